#pragma once

namespace sonoskin {

// returnFreeMemory: gives the system back what has been freed but is kept for later: after a step that needed much more
// memory than the next one will. Without it as much again stays in holes between what is in use.
//   cost   2 ms, and the pages anew where memory is needed again
void returnFreeMemory();

}  // namespace sonoskin
