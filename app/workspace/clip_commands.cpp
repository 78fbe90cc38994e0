#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/workspace/clip_edits.h"
#include "app/workspace/command_tables.h"
#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

using W = Workspace;

constexpr const char* kMenu = "Clip plane";

bool clips(const W& w) { return w.view.clip.on; }

template <Plane plane>
void across(W& w) {
  clipFromPlane(w, plane);
}

// clang-format off
const Command kCommands[] = {
  {"clip.on", "Cut what 3D shows", Menu::view, key(GLFW_KEY_G), switchClip, hasScan, clips, true, kMenu},
  {"clip.view", "Facing the view", Menu::view, {}, clipFromView, hasScan, nullptr, true, kMenu},
  {"clip.axial", "Axial (A), through the cross-hair", Menu::view, {}, across<Plane::axial>, hasScan, nullptr, false, kMenu},
  {"clip.sagittal", "Sagittal (B), through the cross-hair", Menu::view, {}, across<Plane::sagittal>, hasScan, nullptr, false, kMenu},
  {"clip.coronal", "Coronal (C), through the cross-hair", Menu::view, {}, across<Plane::coronal>, hasScan, nullptr, false, kMenu},
  {"clip.flip", "The other side", Menu::view, {}, flipClip, clips, nullptr, false, kMenu},
};
// clang-format on

}  // namespace

std::span<const Command> clipCommands() { return kCommands; }

}  // namespace sonoskin
