#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sonoskin {

// toBase64, fromBase64: bytes as letters, with padding; blanks between them are skipped, and nothing comes of what is no
// base64. [RFC 4648, section 4]
std::string toBase64(std::span<const std::uint8_t> bytes);
std::optional<std::vector<std::uint8_t>> fromBase64(std::string_view text);

}  // namespace sonoskin
