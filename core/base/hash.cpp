#include "core/base/hash.h"

#include <fmt/format.h>
#include <xxhash.h>

namespace sonoskin {

std::string Key::hex() const { return fmt::format("{:016x}{:016x}", high, low); }

Hasher& Hasher::addBytes(const void* data, std::size_t bytes) {
  // Chained: the bytes' own fingerprint is folded into the state, so that no copy of large data is made.
  const XXH128_hash_t content = XXH3_128bits(data, bytes);
  const std::array<std::uint64_t, 4> link{state_.high, state_.low, content.high64, content.low64};
  const XXH128_hash_t next = XXH3_128bits(link.data(), sizeof link);
  state_ = {next.high64, next.low64};
  return *this;
}

Hasher& Hasher::add(std::string_view text) { return addBytes(text.data(), text.size()); }

Hasher& Hasher::add(const Key& key) { return add(key.high).add(key.low); }

}  // namespace sonoskin
