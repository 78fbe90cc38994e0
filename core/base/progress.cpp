#include "core/base/progress.h"

#include "core/base/error.h"

namespace sonoskin {

void Progress::throwIfCancelled() const {
  if (cancelled()) throw Cancelled{};
}

}  // namespace sonoskin
