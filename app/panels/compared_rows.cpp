// How the ray-casts are shown that are compared.
#include <imgui.h>

#include "app/panels/view_rows.h"
#include "app/texts/texts.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"

namespace sonoskin::ui {

void drawComparedRows(Workspace& workspace) {
  if (workspace.settings.layout.layout != Layout::casts) return;
  ImGui::TextUnformatted(tr("Raw, classified and thinned beside it"));
  int style = static_cast<int>(workspace.view.comparedStyle);
  if (textSegments("view.comparedStyle", {"Surface", "Translucent", "Maximum"}, style))
    workspace.view.comparedStyle = VolumeStyle(style);
  ImGui::Separator();
}

}  // namespace sonoskin::ui
