#pragma once

#include <string>
#include <string_view>

namespace sonoskin {

// shownText: text of a stranger as a message may show it: 60 bytes at most, and without what a terminal would obey.
std::string shownText(std::string_view text);

}  // namespace sonoskin
