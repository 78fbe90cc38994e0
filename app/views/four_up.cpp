#include "app/views/four_up.h"

#include <algorithm>

#include "app/views/layouts.h"
#include "app/views/use_tool.h"
#include "app/workspace/shown_layers.h"

namespace sonoskin::ui {
namespace {

// Names of the views for the interface: those that are compared are others.
const char* nameOf(const Cell& cell) {
  constexpr std::array<const char*, 4> kNames{"axial", "space", "sagittal", "coronal"};
  constexpr std::array<const char*, 3> kLayers{"raw", "classified", "thinned"};
  return cell.layer ? kLayers[std::size_t(*cell.layer)] : kNames[std::size_t(cell.pane)];
}

double drawContent(FourUp& views, Workspace& workspace, const Cell& cell, const PaneInput& pane) {
  if (cell.pane == Pane::space) return drawSpaceWindow(views.space, views.scans, workspace, pane);
  const ShownSlice shown{cell.plane, cell.layer.value_or(workspace.view.layer), cell.layer.has_value()};
  SliceWindow& window =
      cell.layer ? views.compared[std::size_t(*cell.layer)] : views.slices[std::size_t(cell.plane)];
  drawSliceWindow(window, shown, views.sliceView, views.scans, workspace, pane);
  return -1;
}

double drawCell(FourUp& views, Workspace& workspace, const Cell& cell) {
  const PaneKind kind = cell.pane == Pane::space ? PaneKind::space : PaneKind::slice;
  PaneInput pane = beginPane(nameOf(cell), cell.corner, cell.size);
  const bool alone = pane.doubleClicked && !takesDoubleClicks(workspace, kind);
  pane = views.clicks.filter(pane, alone, workspace.view.cursor);
  const double next = drawContent(views, workspace, cell, pane);
  endPane();
  views.shown.push_back({cell.pane, pane.corner, pane.size, cell.layer.has_value()});
  if (alone) {
    if (workspace.view.maximised) {
      workspace.view.maximised.reset();
    } else {
      workspace.view.maximised = cell.pane;
    }
  }
  return next;
}

// What the GPU holds of a document goes with it. Results that are made anew take the place of those before.
void letGoOfClosed(FourUp& views, const Results& results) {
  if (!results.classified) views.scans.classified = {};
  if (std::ranges::all_of(results.slices, [](const auto& slice) { return !slice; })) views.scans.slices = {};
  if (!results.thinned) views.scans.thinned = {};
  if (results.mesh) return;
  views.space.mesh.set(nullptr);
  views.space.skin.letGo();
  views.space.parts = {};
}

constexpr double kCopySeconds = 0.012;  // a frame

// What has arrived is copied in pieces, over some frames. Of volumes that are shown nowhere nothing is copied.
void copyVolumes(GpuScans& scans, const Workspace& w) {
  const ViewState& view = w.view;
  const Results& results = w.session.results();
  const bool inSpace = !showsMesh(w);
  const auto copy = [&](GpuVolume& to, const auto& volume, bool space, SliceLayer layer) {
    if (!volume || !(space || isInSlices(w, layer))) return;
    to.set(volume);
    // What the driver cannot hold is told by the view that shows it.
    failureOf([&] { scans.ready &= to.prepare(kCopySeconds, space); });
  };
  scans.ready = true;
  const bool isRaw = view.volumeLayer == VolumeLayer::raw || !results.classified;
  copy(scans.raw, w.session.scan().volume, inSpace && isRaw, SliceLayer::raw);
  copy(scans.classified, results.classified, inSpace && !isRaw, SliceLayer::classified);
  copy(scans.thinned, results.thinned, false, SliceLayer::thinned);
}

// When the next frame is wanted: at once while something is on its way.
double soonest(double next, const GpuScans& scans) { return scans.ready ? next : 0; }

}  // namespace

double drawFourUp(FourUp& views, Workspace& workspace) {
  letGoOfClosed(views, workspace.session.results());
  copyVolumes(views.scans, workspace);
  if (workspace.session.hasScan())
    workspace.view.planes = planeAxes(workspace.session.scan().volume->geometry, workspace.viewFrame());
  views.shown.clear();
  const ImVec2 corner = ImGui::GetCursorScreenPos(), area = ImGui::GetContentRegionAvail();
  LayoutState& layout = workspace.settings.layout;
  const Cells cells = cellsOf(layout, corner, area);
  // A copy: a double click changes it, and that counts from the next frame.
  if (const auto maximised = workspace.view.maximised) {
    Cell cell = *std::ranges::find(cells, *maximised, &Cell::pane);
    cell.corner = corner;
    cell.size = area;
    return soonest(drawCell(views, workspace, cell), views.scans);
  }
  double next = -1;
  for (const Cell& cell : cells) {
    const double wanted = drawCell(views, workspace, cell);
    if (cell.pane == Pane::space) next = wanted;
  }
  drawDividers(layout, corner, area);
  return soonest(next, views.scans);
}

}  // namespace sonoskin::ui
