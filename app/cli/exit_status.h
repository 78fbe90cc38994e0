#pragma once

namespace sonoskin {

// ExitStatus: what the program tells its caller.
enum ExitStatus { kDone = 0, kOther = 1, kUsage = 2, kInput = 3, kCancelled = 4 };

inline constexpr const char* kCancelledSentence = "cancelled; nothing was written";

}  // namespace sonoskin
