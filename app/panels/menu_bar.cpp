#include <imgui.h>

#include <array>
#include <utility>

#include "app/panels/panels.h"
#include "app/texts/texts.h"
#include "app/widgets/open_lists.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/commands.h"
#include "app/workspace/session_actions.h"

namespace sonoskin::ui {
namespace {

void drawRecent(Workspace& workspace) {
  if (!ImGui::BeginMenu(trId("Open recent").c_str())) return;
  std::filesystem::path chosen;  // opening reorders the list
  for (const auto& file : workspace.settings.recent) {
    if (ImGui::MenuItem(file.c_str())) chosen = file;
  }
  if (!chosen.empty()) openAny(workspace, chosen);
  if (!workspace.settings.recent.empty()) ImGui::Separator();
  const bool forget = ImGui::MenuItem(tr("Forget these"), nullptr, false, !workspace.settings.recent.empty());
  const bool other = ImGui::MenuItem(tr("Remember files"), nullptr, &workspace.settings.remembersFiles);
  if (forget || !workspace.settings.remembersFiles) workspace.settings.recent.clear();
  if (forget || other) workspace.keepSettings();
  ImGui::EndMenu();
}

// Submenus: opens and closes them between commands that stand in different ones. enter: whether what stands in one is seen.
class Submenus {
 public:
  ~Submenus() { close(); }
  bool enter(const char* submenu, bool separator) {
    const bool same = submenu && title_ && std::string_view(submenu) == title_;
    if (!same) close();
    if (separator && (!same || open_)) ImGui::Separator();
    if (!same) {
      open_ = !submenu || ImGui::BeginMenu(trId(submenu).c_str());
      if (submenu) noteWidget(std::string("submenu.") + submenu);
    }
    title_ = submenu;
    return open_;
  }

 private:
  void close() {
    if (title_ && open_) ImGui::EndMenu();
    title_ = nullptr;
  }
  const char* title_ = nullptr;
  bool open_ = true;
};

void drawMenu(Menu menu, Workspace& workspace) {
  Submenus submenus;
  for (const Command& command : commands()) {
    if (command.menu != menu) continue;
    if (!submenus.enter(command.submenu, command.separator)) continue;
    const bool checked = command.checked && command.checked(workspace);
    if (ImGui::MenuItem(fmt::format("{}###{}", tr(command.title), command.id).c_str(),
                        shortcutText(command.shortcut).c_str(), checked, isEnabled(command, workspace))) {
      command.run(workspace);
    }
    if (command.id == std::string_view("file.open")) drawRecent(workspace);
  }
}

}  // namespace

void drawMenuBar(Workspace& workspace) {
  if (!ImGui::BeginMainMenuBar()) return;
  // Before all menus: they share a window, and the one that is open would be drawn into it once more.
  if (const auto asked = std::exchange(workspace.menuAsked, std::nullopt))
    openMenu(trId(kMenuTitles[std::size_t(*asked)]).c_str());
  std::size_t shown = 0;  // that is open
  for (std::size_t i = 0; i < kMenuTitles.size(); ++i) {
    const bool open = ImGui::BeginMenu(trId(kMenuTitles[i]).c_str());
    noteWidget(std::string("menu.") + kMenuTitles[i]);
    if (!open) continue;
    drawMenu(static_cast<Menu>(i), workspace);
    ImGui::EndMenu();
    shown = i;
  }
  if (const int step = leavesMenu(); step != 0)
    workspace.menuAsked =
        static_cast<Menu>((shown + kMenuTitles.size() + std::size_t(step)) % kMenuTitles.size());
  ImGui::EndMainMenuBar();
}

}  // namespace sonoskin::ui
