#include "app/views/four_up.h"

#include <cmath>

#include "app/views/use_tool.h"
#include "app/widgets/theme.h"

namespace sonoskin::ui {
namespace {

const char* nameOf(Pane pane) {
  constexpr std::array<const char*, 4> kNames{"axial", "space", "sagittal", "coronal"};
  return kNames[std::size_t(pane)];
}

Plane planeOf(Pane pane) {
  switch (pane) {
    case Pane::sagittal:
      return Plane::sagittal;
    case Pane::coronal:
      return Plane::coronal;
    default:
      return Plane::axial;
  }
}

double drawPane(FourUp& views, Workspace& workspace, Pane which, ImVec2 corner, ImVec2 size) {
  double next = -1;
  const PaneKind kind = which == Pane::space ? PaneKind::space : PaneKind::slice;
  PaneInput pane = beginPane(nameOf(which), corner, size);
  const bool alone = pane.doubleClicked && !takesDoubleClicks(workspace, kind);
  pane = views.clicks.filter(pane, alone, workspace.view.cursor);
  if (which == Pane::space) {
    next = drawSpaceWindow(views.space, views.scans, workspace, pane);
  } else {
    const Plane plane = planeOf(which);
    drawSliceWindow(views.slices[std::size_t(plane)], plane, views.sliceView, views.scans, workspace, pane);
  }
  endPane();
  views.shown.push_back({which, pane.corner, pane.size});
  if (alone) {
    if (workspace.view.maximised) {
      workspace.view.maximised.reset();
    } else {
      workspace.view.maximised = which;
    }
  }
  return next;
}

// What the GPU holds of a document goes with it. Results that are made anew take the place of those before.
void letGoOfClosed(FourUp& views, const Results& results) {
  if (!results.classified) views.scans.classified = {};
  if (!results.slices[0]) views.scans.slices = {};
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
    const bool marks = layer == SliceLayer::thinned && view.surfaceVoxels;
    if (!volume || !(space || marks || view.layer == layer)) return;
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
  // A copy: a double click changes it, and that counts from the next frame.
  if (const auto maximised = workspace.view.maximised)
    return soonest(drawPane(views, workspace, *maximised, corner, area), views.scans);
  const float gap = std::round(2 * unit());
  const ImVec2 size{std::floor((area.x - gap) / 2), std::floor((area.y - gap) / 2)};
  double next = -1;
  for (int i = 0; i < 4; ++i) {
    const Pane pane = kPanes[std::size_t(i)];
    const double wanted =
        drawPane(views, workspace, pane,
                 {corner.x + float(i % 2) * (size.x + gap), corner.y + float(i / 2) * (size.y + gap)}, size);
    if (pane == Pane::space) next = wanted;
  }
  return soonest(next, views.scans);
}

}  // namespace sonoskin::ui
