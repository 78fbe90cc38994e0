#include "app/views/four_up.h"

#include <algorithm>
#include <span>
#include <utility>

#include "app/views/cast_window.h"
#include "app/views/layouts.h"
#include "app/views/use_tool.h"
#include "app/workspace/shown_layers.h"
#include "core/base/free_memory.h"

namespace sonoskin::ui {
namespace {

// Names of the views for the interface: those that are compared are others.
const char* nameOf(const Cell& cell) {
  constexpr std::array<const char*, 5> kNames{"axial", "space", "sagittal", "coronal", "oblique"};
  constexpr std::array<const char*, 3> kLayers{"raw", "classified", "thinned"};
  return cell.layer ? kLayers[std::size_t(*cell.layer)] : kNames[std::size_t(cell.pane)];
}

double drawContent(FourUp& views, Workspace& workspace, const Cell& cell, const PaneInput& pane) {
  if (cell.pane == Pane::space) return drawSpaceWindow(views.space, views.scans, workspace, pane);
  if (cell.cast) return drawCast((*views.casts)[std::size_t(*cell.layer)], views.scans, workspace, pane);
  const ShownSlice shown{cell.plane, cell.layer.value_or(workspace.view.layer), cell.layer.has_value()};
  SliceWindow& window = cell.layer   ? views.compared[std::size_t(*cell.layer)]
                        : cell.plane ? views.slices[std::size_t(*cell.plane)]
                                     : views.oblique;
  drawSliceWindow(window, shown, views.sliceView, views.scans, workspace, pane);
  return -1;
}

// Whether two quick clicks are the tool's; ray-casts that are compared have none.
bool takesDoubleClicks(const Workspace& workspace, const Cell& cell) {
  if (cell.cast) return false;
  return takesDoubleClicks(workspace, cell.pane == Pane::space ? PaneKind::space : PaneKind::slice);
}

double drawCell(FourUp& views, Workspace& workspace, const Cell& cell) {
  PaneInput pane = beginPane(nameOf(cell), cell.corner, cell.size);
  const bool alone = pane.doubleClicked && !takesDoubleClicks(workspace, cell);
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
  const bool inSpace = !showsMesh(w), casts = w.settings.layout.layout == Layout::casts;
  const auto copy = [&](GpuVolume& to, const auto& volume, bool space, SliceLayer layer) {
    if (!volume || !(space || isInSlices(w, layer))) return;
    to.set(volume);
    // What the driver cannot hold is told by the view that shows it.
    failureOf([&] { scans.ready &= to.prepare(kCopySeconds, space); });
  };
  scans.ready = true;
  const bool isRaw = view.volumeLayer == VolumeLayer::raw || !results.classified;
  copy(scans.raw, w.session.scan().volume, casts || (inSpace && isRaw), SliceLayer::raw);
  copy(scans.classified, results.classified, casts || (inSpace && !isRaw), SliceLayer::classified);
  copy(scans.thinned, results.thinned, casts, SliceLayer::thinned);
}

// The ray-casts that are compared, and what volumes need for them alone, are there as long as they are shown.
void makeCasts(FourUp& views, const Workspace& w) {
  const bool shown = w.settings.layout.layout == Layout::casts;
  if (shown == (views.casts != nullptr)) return;
  if (shown) {
    views.casts = std::make_unique<std::array<SpaceWindow, 3>>();
    for (std::size_t n = 0; n < 3; ++n) (*views.casts)[n].compared = SliceLayer(n);
  } else {
    views.casts.reset();
    views.scans.raw = {};
    views.scans.classified = {};
    views.scans.thinned = {};
    returnFreeMemory();
  }
}

// The cells that are shown: one, where it is seen alone.
Cells shownCells(const Workspace& w, ImVec2 corner, ImVec2 area) {
  const Cells cells = cellsOf(w.settings.layout, corner, area);
  if (!w.view.maximised) return cells;
  const auto found = std::ranges::find(cells, *w.view.maximised, &Cell::pane);
  if (found == cells.end()) return cells;  // a session of another layout
  Cell cell = *found;
  cell.corner = corner;
  cell.size = area;
  return {cell};
}

// The views of some cells that show 3D.
std::vector<SpaceWindow*> spaceWindows(FourUp& views, const Cells& cells) {
  std::vector<SpaceWindow*> windows;
  for (const Cell& cell : cells)
    if (cell.cast)
      windows.push_back(&(*views.casts)[std::size_t(*cell.layer)]);
    else if (cell.pane == Pane::space)
      windows.push_back(&views.space);
  return windows;
}

// This frame's time among them.
void shareTime(std::span<SpaceWindow* const> windows, SharedTime& time, double frameSeconds) {
  std::vector<SharingView> sharing;
  for (SpaceWindow* window : windows)
    sharing.push_back({std::exchange(window->pictureSeconds, 0), window->draftSeconds, window->steered,
                       window->picture && window->state.unfinished});
  std::vector<FrameShare> shares(windows.size());
  shareFrame(sharing, frameSeconds, time, shares);
  for (std::size_t n = 0; n < windows.size(); ++n) windows[n]->share = shares[n];
}

// Whether what moved them has come to rest in this frame, which they learn in the next.
bool haveStopped(std::span<SpaceWindow* const> windows) {
  return std::ranges::any_of(windows, [](const SpaceWindow* window) { return window->share.moves; }) &&
         std::ranges::none_of(windows, &SpaceWindow::steered);
}

// When the next frame is wanted: at once while something is on its way.
double soonest(double next, const GpuScans& scans) { return scans.ready ? next : 0; }

// The sooner of two times; a negative one is none.
double sooner(double a, double b) { return a < 0 ? b : b < 0 ? a : std::min(a, b); }

}  // namespace

double drawFourUp(FourUp& views, Workspace& workspace) {
  letGoOfClosed(views, workspace.session.results());
  makeCasts(views, workspace);
  copyVolumes(views.scans, workspace);
  if (workspace.session.hasScan())
    workspace.view.planes = planeAxes(workspace.session.scan().volume->geometry, workspace.viewFrame());
  views.shown.clear();
  const ImVec2 corner = ImGui::GetCursorScreenPos(), area = ImGui::GetContentRegionAvail();
  const Cells cells = shownCells(workspace, corner, area);
  const std::vector<SpaceWindow*> windows = spaceWindows(views, cells);
  shareTime(windows, views.time, workspace.view.frameSeconds);
  double next = -1;
  for (const Cell& cell : cells) next = sooner(next, drawCell(views, workspace, cell));
  if (cells.size() > 1) drawDividers(workspace.settings.layout, corner, area);
  return haveStopped(windows) ? 0 : soonest(next, views.scans);
}

}  // namespace sonoskin::ui
