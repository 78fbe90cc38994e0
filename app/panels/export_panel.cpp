#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <vector>

#include "app/panels/panels.h"
#include "app/panels/parameter_rows.h"
#include "app/texts/texts.h"
#include "app/widgets/layout.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/commands.h"

namespace sonoskin::ui {
namespace {

// Block: commands that write files of one kind, and what these hold.
struct Block {
  const char *title, *help;
  std::vector<const char*> commands;
};
const std::array<Block, 4> kBlocks{
    Block{"Surface",
          "PLY, STL, OBJ in mm, GLB in metres; the recipe that makes it again lies beside it.",
          {"file.saveMesh", "file.saveSequence"}},
    Block{"Pictures and skin",
          "What the 3D view shows, as PNG; or the surface with its colours, as GLB.",
          {"file.savePicture", "file.saveTurntable", "file.saveSkin", "file.saveLitSkin"}},
    Block{"Volumes",
          "As voxels, for other programs.",
          {"file.saveScan", "file.saveClassified", "file.saveErased"}},
    Block{"Recipe", "All parameters, to be opened on another scan.", {"file.saveRecipe", "file.openRecipe"}}};

void commandButton(const char* id, Workspace& workspace) {
  const Command& save = command(id);
  const DisabledIf disabled(!isEnabled(save, workspace));
  if (ImGui::Button(tr(save.title), {-1, 0})) save.run(workspace);
  noteWidget(save.id);
  if (const std::string key = shortcutText(save.shortcut); !key.empty() && ImGui::IsItemHovered())
    ImGui::SetTooltip("%s", key.c_str());
}

}  // namespace

void drawExportPanel(Workspace& workspace) {
  for (const Block& block : kBlocks) {
    heading(tr(block.title));
    sentenceText(tr(block.help));
    for (const char* id : block.commands) commandButton(id, workspace);
  }
  Parameters parameters = workspace.session.parameters();
  const FieldsEdit edit =
      groupRows(tr("A solid to print"), "print", parameters.print, {{}, false, useOf(parameters, "print")});
  applyEdit(workspace, parameters, edit);
  commandButton("file.savePrint", workspace);
}

}  // namespace sonoskin::ui
