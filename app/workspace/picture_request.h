#pragma once

#include <array>
#include <optional>

namespace sonoskin {

// PictureFormat: of the pictures that are saved of the 3D view.
//   views   of a turntable
struct PictureFormat {
  std::array<int, 2> size{1280, 960};
  bool transparent = false;
  int views = 72;
};

// PictureRequest: what the person is asked before a file is chosen: the format of one picture, or of a turntable.
struct PictureRequest {
  bool turntable = false;
};

}  // namespace sonoskin
