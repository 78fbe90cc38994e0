#pragma once

#include <array>

namespace sonoskin {

// Appearance: what the window looks like around the views, whose pictures are dark in either.
enum class Appearance { dark, light };
constexpr std::array<const char*, 2> enumNames(Appearance) { return {"dark", "light"}; }

}  // namespace sonoskin
