#include "app/window/menu_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <optional>

#include "app/texts/texts.h"
#include "app/widgets/open_lists.h"

namespace sonoskin {
namespace {

// The menu whose title, in the window's language, begins with the letter of a key.
std::optional<Menu> menuOf(int key) {
  for (std::size_t i = 0; i < kMenuTitles.size(); ++i)
    if (tr(kMenuTitles[i])[0] == char(key)) return static_cast<Menu>(i);
  return {};
}

}  // namespace

void MenuKeys::beforeFrame() { lists_ = ui::openLists(); }

// Whether Alt has gone up after it went down, with nothing but the mouse's way in between.
bool MenuKeys::altAlone(const Event& event) {
  if (event.kind == Event::Kind::position) return false;
  const bool isAlt = event.kind == Event::Kind::key && event.code == GLFW_KEY_LEFT_ALT;
  const bool was = alt_;
  alt_ = isAlt && event.down && !event.control && !event.shift;
  return was && isAlt && !event.down;
}

bool MenuKeys::take(const Event& event, Workspace& workspace) {
  const bool alone = altAlone(event);
  if (event.kind != Event::Kind::key) return false;
  if (lists_ > 0) {
    if (event.down && event.code == GLFW_KEY_ESCAPE) ui::closeLists();
    return true;
  }
  std::optional<Menu> asked;
  if (alone || (event.down && event.code == GLFW_KEY_F10)) asked = Menu::file;
  if (event.down && event.alt) asked = menuOf(event.code);
  if (asked) workspace.menuAsked = asked;
  return asked.has_value();
}

}  // namespace sonoskin
