#include "core/base/shown_text.h"

namespace sonoskin {

std::string shownText(std::string_view text) {
  constexpr std::size_t kMost = 60;
  std::string shown(text.substr(0, kMost));
  for (char& c : shown)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return text.size() > kMost ? shown + "..." : shown;
}

}  // namespace sonoskin
