#include "app/panels/panels.h"
#include "app/widgets/layout.h"
#include "app/widgets/profile_plot.h"

namespace sonoskin::ui {

void drawProfilePanel(Workspace& workspace) {
  if (!foldout("Profile", "How far light of each colour goes below the skin.")) return;
  static ProfilePlot plot;
  drawProfilePlot(plot, workspace.session.parameters().skin);
}

}  // namespace sonoskin::ui
