#pragma once

#include <string>

namespace sonoskin::gl {

// requireMade: the driver has made what it was asked for; without a look it draws black, or nothing, in silence.
//   input   made  whether the object is as it was asked for
//           what  "a texture of 512 x 512 x 300 texels"
//   errors  Error (system): it is not, or there was no memory for something since the last look
void requireMade(bool made, const std::string& what);

}  // namespace sonoskin::gl
