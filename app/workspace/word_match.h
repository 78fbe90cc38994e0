#pragma once

#include <optional>
#include <string_view>

namespace sonoskin {

// misfit: how badly words fit a text, 0 the best; nothing where they do not. Each of them must be made of beginnings of words
// of the text, in their order: "rec sur", "recsur" and "rs" fit "Reconstruct surface". Capital letters count as small ones.
std::optional<int> misfit(std::string_view words, std::string_view text);

}  // namespace sonoskin
