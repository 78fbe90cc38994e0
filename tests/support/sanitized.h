#pragma once

namespace sonoskin::test {

// kSanitized: whether this is a build with sanitizers, which map terabytes of addresses, so that no limit on them can be
// tried.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace sonoskin::test
