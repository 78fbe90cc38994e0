#include "app/views/slice_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/texts/texts.h"
#include "app/views/edge_marks.h"
#include "app/views/measure_marks.h"
#include "app/views/oblique_marks.h"
#include "app/views/slice_overlays.h"
#include "app/views/slice_picture.h"
#include "app/views/steering.h"
#include "app/views/use_tool.h"
#include "app/widgets/theme.h"
#include "app/workspace/grey_windows.h"

namespace sonoskin::ui {
namespace {

ImVec4 colourOf(SlicePlane plane) {
  const std::array<ImVec4, 3> colours{kSagittal, kCoronal, kAxial};
  return plane ? colours[std::size_t(*plane)] : kOblique;
}

std::string nameOf(const ViewFrame& frame, const ShownSlice& shown) {
  const std::string plane = shown.plane ? tr(planeName(frame, *shown.plane)) : tr("Oblique");
  if (!shown.compared) return plane;
  return fmt::format("{}   {}", tr(layerName(shown.layer)), plane);
}

// Where the slice lies: counted along its axis, and where that is in the world or from the probe.
std::string placeText(const Workspace& w, const ViewFrame& frame, SlicePlane shown) {
  if (!shown) return {};  // its angles stand in its bar
  const Plane plane = *shown;
  const Geometry& g = w.session.scan().volume->geometry;
  const SliceAxes& axes = w.view.planes[plane];
  const int last = g.dims[axes.across];
  const int index = static_cast<int>(std::lround(g.toIndex(w.view.cursor)[axes.across]));
  const int before = axes.acrossGrows ? index : last - 1 - index;
  const std::string count = trf("{} of {}", before + 1, last);
  if (!frame.isPatient) return fmt::format("{}   {:.1f} mm", count, double(before) * g.spacing[axes.across]);
  const double at = w.view.cursor[int(plane)];
  return fmt::format("{}   {} {:.1f} mm", count, "RLAPIS"[2 * int(plane) + (at > 0 ? 1 : 0)], std::abs(at));
}

// At the lower left: the grey window while it is dragged, else what the mouse points at.
void drawPointer(const PaneInput& pane, const Workspace& w, const SliceFrame& frame) {
  const bool drags = pane.button == ImGuiMouseButton_Right;
  if (!drags && !pane.hovered) return;
  const std::string text = drags ? windowText(w.session.scan(), w.view.grey) : pointerText(w, frame, pane);
  const float u = unit();
  const ImVec2 place{pane.corner.x + 12 * u, pane.corner.y + pane.size.y - 22 * u};
  const ImVec2 size = smallFont()->CalcTextSizeA(smallFont()->FontSize, FLT_MAX, 0, text.c_str());
  if (text.empty()) return;
  ImGui::GetWindowDrawList()->AddRectFilled({place.x - 4 * u, place.y - 2 * u},
                                            {place.x + size.x + 4 * u, place.y + size.y + 2 * u},
                                            IM_COL32(6, 7, 9, 190), 3 * u);
  shadedText(place, kText, text);
}

void drawMarks(const PaneInput& pane, const Workspace& w, const ShownSlice& shown) {
  const ViewFrame frame = w.viewFrame();
  const bool coarse =
      shown.layer == SliceLayer::classified && w.session.classifiedIsCoarse() && !isAnswered(w, shown.plane);
  const SliceFrame slice = frameOf(w.view, shown.plane, w.session.scan().volume->geometry, pane);
  drawEdges(pane, frame, slice);
  paneTitle(pane, nameOf(frame, shown).c_str(), colourOf(shown.plane),
            placeText(w, frame, shown.plane) + (coarse ? std::string("   ") + tr("coarse") : ""));
  drawPointer(pane, w, slice);
  scaleBar(pane, 1 / slice.millimetresPerPixel());
}

}  // namespace

void drawSliceWindow(SliceWindow& window, const ShownSlice& shown, std::optional<SliceView>& view,
                     GpuScans& scans, Workspace& workspace, const PaneInput& pane) {
  if (!workspace.session.hasScan()) {
    paneTitle(pane, nameOf({}, shown).c_str(), colourOf(shown.plane), "");
    return;
  }
  const Geometry& geometry = workspace.session.scan().volume->geometry;
  const auto seen = [&] {
    return ToolPane{pane, ToolPane::Slice{shown.plane, frameOf(workspace.view, shown.plane, geometry, pane)}};
  };
  if (pane.hovered) workspace.view.pointedAt = shown.plane;
  if (!shown.compared) linkZoom(workspace.view, shown.plane, geometry, pane);
  useTool(window.tools, workspace, seen());
  if (isThere(workspace, shown.layer) || !shown.compared) {
    refreshSlice(window, shown, view, scans, workspace, glm::max(glm::ivec2(pane.size), glm::ivec2(1)));
    showTexture(pane, window.picture);
  } else {
    paneText(pane, tr("Not made yet"));
  }
  if (!shown.compared) drawOverlays(window, workspace, seen().slice->frame, pane);
  drawMeasuresInSlice(pane, workspace, seen().slice->frame);
  drawPlaneLines(window.tools, workspace, seen());
  drawTool(window.tools, workspace, seen());
  drawMarks(pane, workspace, shown);
}

}  // namespace sonoskin::ui
