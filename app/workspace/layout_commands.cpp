// Which views share the window.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/workspace/command_tables.h"
#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

using W = Workspace;

void setLayout(W& w, Layout layout) {
  w.settings.layout.layout = layout;
  w.view.maximised.reset();
  if (layout != Layout::oblique && !w.view.pointedAt) w.view.pointedAt = Plane::axial;
}

// The classified volume is compared as a surface too.
template <Layout layout>
void compare(W& w) {
  setLayout(w, layout);
  w.view.content = SpaceContent::volume;
  w.view.volumeLayer = VolumeLayer::classified;
  w.view.volumeStyle = VolumeStyle::surface;
}

template <Layout layout>
bool isLayout(const W& w) {
  return w.settings.layout.layout == layout;
}

void comparePlane(W& w) {
  Plane& plane = w.settings.layout.compared;
  plane = plane == Plane::axial ? Plane::sagittal : plane == Plane::sagittal ? Plane::coronal : Plane::axial;
}

// A slice that is no other than the axial one is turned a little, so that it is seen what it is.
void showOblique(W& w) {
  setLayout(w, Layout::oblique);
  if (!hasScan(w)) return;
  const Geometry& g = w.session.scan().volume->geometry;
  w.view.planes = planeAxes(g, w.viewFrame());
  const PlaneDirections axial = directionsOf(g, w.view.planes[Plane::axial]);
  PlaneDirections& plane = w.view.oblique.directions;
  if (glm::dot(plane.normal(), axial.normal()) > 0.9999) plane = directionsAt({.tilt = 30}, axial);
}

constexpr const char* kLayout = "Layout";

// clang-format off
const Command kCommands[] = {
  {"layout.fourUp", "Three planes and 3D", Menu::view, key(GLFW_KEY_F2), [](W& w) { setLayout(w, Layout::fourUp); },
   nullptr, isLayout<Layout::fourUp>, true, kLayout},
  {"layout.compare", "Compare raw, classified, thinned and surface", Menu::view, key(GLFW_KEY_F3), compare<Layout::compare>,
   nullptr, isLayout<Layout::compare>, false, kLayout},
  {"layout.comparePlane", "Compare the next plane", Menu::view, {GLFW_KEY_F3, false, true}, comparePlane,
   isLayout<Layout::compare>, nullptr, false, kLayout},
  {"layout.casts", "Compare them in 3D, with one camera", Menu::view, key(GLFW_KEY_F4), compare<Layout::casts>, nullptr,
   isLayout<Layout::casts>, false, kLayout},
  {"layout.oblique", "Oblique slice, 3D and three planes", Menu::view, key(GLFW_KEY_F5), showOblique, nullptr,
   isLayout<Layout::oblique>, false, kLayout},
  {"layout.middle", "Dividers to the middle", Menu::view, {},
   [](W& w) { w.settings.layout.across = w.settings.layout.down = 0.5f; }, nullptr, nullptr, true, kLayout},
};
// clang-format on

}  // namespace

std::span<const Command> layoutCommands() { return kCommands; }

}  // namespace sonoskin
