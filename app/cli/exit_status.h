#pragma once

#include "core/io/staging.h"

namespace sonoskin {

// ExitStatus: what the program tells its caller.
enum ExitStatus { kDone = 0, kOther = 1, kUsage = 2, kInput = 3, kCancelled = 4 };

// cancelledSentence: what a person who cancels is told.
inline const char* cancelledSentence() {
  return hasPublished() ? "Cancelled; the surface is written, its pictures are not."
                        : "Cancelled; nothing was written.";
}

}  // namespace sonoskin
