#pragma once

#include <cstddef>

namespace sonoskin {

// availableMemory: bytes that can still be taken without another program losing its own: what the system says is
// available, or what is left of a limit of the control group or the process where that is less. Very much where none of
// these is told.
std::size_t availableMemory();

}  // namespace sonoskin
