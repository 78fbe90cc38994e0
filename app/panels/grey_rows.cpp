#include "app/panels/grey_rows.h"

#include <fmt/format.h>
#include <imgui.h>

#include <initializer_list>

#include "app/texts/texts.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/commands.h"
#include "app/workspace/grey_windows.h"

namespace sonoskin::ui {
namespace {

struct Ready {
  const char *id, *name;
};

// One row of buttons over the whole width.
void drawReady(Workspace& workspace, std::initializer_list<Ready> ready) {
  const float gap = 4 * unit(), count = float(ready.size());
  const float width = (ImGui::GetContentRegionAvail().x - (count - 1) * gap) / count;
  for (const Ready& one : ready) {
    if (&one != ready.begin()) ImGui::SameLine(0, gap);
    if (ImGui::Button(fmt::format("{}###{}", tr(one.name), one.id).c_str(), {width, 0}))
      command(one.id).run(workspace);
    noteWidget(one.id);
  }
}

}  // namespace

void drawGreyRows(Workspace& workspace) {
  const Scan& scan = workspace.session.scan();
  ImGui::TextDisabled("%s", windowText(scan, workspace.view.grey).c_str());
  drawReady(workspace, {{"slices.whole", "All values"}, {"slices.automatic", "Automatic"}});
  if (isCt(scan))
    drawReady(workspace, {{"slices.bone", "Bone"}, {"slices.soft", "Soft tissue"}, {"slices.skin", "Skin"}});
}

}  // namespace sonoskin::ui
