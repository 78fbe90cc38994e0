// What slices show, and the cross-hair by keys.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/workspace/command_tables.h"
#include "app/workspace/cursor_steps.h"
#include "app/workspace/grey_windows.h"
#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

using W = Workspace;

template <int right, int down, int across>
void step(W& w) {
  const Geometry& geometry = w.session.scan().volume->geometry;
  if (w.view.pointedAt)
    stepCursor(w.view, geometry, *w.view.pointedAt, {right, down, across});
  else
    stepOblique(w.view, geometry, {right, down, across});
}

bool isCtScan(const W& w) { return hasScan(w) && isCt(w.session.scan()); }

template <int level, int width>
void showHounsfield(W& w) {
  w.view.grey = hounsfieldWindow(w.session.scan(), level, width);
}

template <bool ViewState::*value>
void toggleIn(W& w) {
  w.view.*value = !(w.view.*value);
}
template <bool ViewState::*value>
bool isOn(const W& w) {
  return w.view.*value;
}

constexpr const char *kGrey = "Brightness of the slices", *kOver = "Over the slices", *kCross = "Cross-hair";

// clang-format off
const Command kCommands[] = {
  {"slices.left", "One voxel to the left", Menu::view, key(GLFW_KEY_LEFT), step<-1, 0, 0>, hasScan, nullptr, true, kCross},
  {"slices.right", "One voxel to the right", Menu::view, key(GLFW_KEY_RIGHT), step<1, 0, 0>, hasScan, nullptr, false, kCross},
  {"slices.up", "One voxel up", Menu::view, key(GLFW_KEY_UP), step<0, -1, 0>, hasScan, nullptr, false, kCross},
  {"slices.down", "One voxel down", Menu::view, key(GLFW_KEY_DOWN), step<0, 1, 0>, hasScan, nullptr, false, kCross},
  {"slices.next", "Next slice", Menu::view, key(GLFW_KEY_PAGE_UP), step<0, 0, 1>, hasScan, nullptr, false, kCross},
  {"slices.previous", "Slice before", Menu::view, key(GLFW_KEY_PAGE_DOWN), step<0, 0, -1>, hasScan, nullptr, false, kCross},
  {"slices.crossHair", "Shown in 3D", Menu::view, key(GLFW_KEY_C), toggleIn<&ViewState::crossHairInSpace>, nullptr,
   isOn<&ViewState::crossHairInSpace>, true, kCross},
  {"slices.whole", "All values", Menu::view, key(GLFW_KEY_0), [](W& w) { w.view.grey = {}; }, hasScan, nullptr, false, kGrey},
  {"slices.automatic", "Automatic: 1 to 99 percent", Menu::view, key(GLFW_KEY_9),
   [](W& w) { w.view.grey = automaticWindow(*w.session.scan().volume); }, hasScan, nullptr, false, kGrey},
  {"slices.bone", "CT: bone", Menu::view, {}, showHounsfield<400, 1800>, isCtScan, nullptr, true, kGrey},
  {"slices.soft", "CT: soft tissue", Menu::view, {}, showHounsfield<40, 400>, isCtScan, nullptr, false, kGrey},
  {"slices.skin", "CT: skin", Menu::view, {}, showHounsfield<-300, 900>, isCtScan, nullptr, false, kGrey},
  {"slices.tint", "Classified volume in colour", Menu::view, key(GLFW_KEY_5), toggleIn<&ViewState::classifiedTint>, hasScan,
   isOn<&ViewState::classifiedTint>, false, kOver},
  {"slices.points", "Points", Menu::view, key(GLFW_KEY_6), toggleIn<&ViewState::slicePoints>, hasScan,
   isOn<&ViewState::slicePoints>, false, kOver},
  {"slices.contour", "Contour of the surface", Menu::view, key(GLFW_KEY_7), toggleIn<&ViewState::meshContour>, hasScan,
   isOn<&ViewState::meshContour>, false, kOver},
  {"slices.linkedZoom", "Zoom all slices together", Menu::view, key(GLFW_KEY_Z), toggleIn<&ViewState::linkedZoom>, nullptr,
   isOn<&ViewState::linkedZoom>},
};
// clang-format on

}  // namespace

std::span<const Command> sliceCommands() { return kCommands; }

}  // namespace sonoskin
