#pragma once

namespace sonoskin {

// giveWay: from now on the calling thread, and those that it makes, get the processor after the other threads of this
// program where both want it: what is computed behind a window must not make it slow. Other programs are treated as before
// where the system shares the processor between programs first, as Linux does for those of a desktop.
//   errors  none: where the system does not allow it, nothing changes
void giveWay();

}  // namespace sonoskin
