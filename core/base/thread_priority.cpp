#include "core/base/thread_priority.h"

#include <sys/resource.h>
#include <unistd.h>

namespace sonoskin {
namespace {

// A third of the share of a thread with the usual niceness. More would starve the work on a machine where all programs
// share the processor alike.
constexpr int kNiceness = 5;

}  // namespace

// Linux has a niceness for each thread, against POSIX.
void giveWay() {
  setpriority(PRIO_PROCESS, id_t(gettid()), kNiceness);  // fails in a thread that has less already
}

}  // namespace sonoskin
