// How the scan lies in all views: whose planes they are, turned and mirrored.
#include "app/workspace/command_tables.h"
#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

using W = Workspace;

void setPlanes(W& w, PlanesChoice choice) {
  w.view.orientation.planes = choice;
  if (!hasScan(w)) return;
  w.lookAtFace();
  if (choice == PlanesChoice::automatic) w.toasts.add(decidePlanes(w.session.scan()).reason, false);
}

bool isTurned(const W& w) { return hasScan(w) && w.view.orientation.turn != glm::dmat3(1); }

void turnBack(W& w) {
  w.view.orientation.turn = glm::dmat3(1);
  w.lookAtFace();
}

// The data are turned over, as the parameter does it, which is exported, undone and written into recipes: left and right are
// true or false of a scan, not of a view. Across the axis that runs to the right in the first of the planes.
void mirror(W& w) {
  Parameters parameters = w.session.parameters();
  const int right = planeAxes(w.session.scan().volume->geometry, w.viewFrame())[Plane::axial].right;
  MirroredAxis& mirror = parameters.scan.mirror;
  mirror = mirror == MirroredAxis::none ? MirroredAxis(1 + right) : MirroredAxis::none;
  w.session.edit(parameters);
  w.session.commitEdit();
}

bool isMirrored(const W& w) { return w.session.parameters().scan.mirror != MirroredAxis::none; }

constexpr const char *kPlanesMenu = "Planes", *kTurn = "Turn and mirror";

template <PlanesChoice choice>
void choose(W& w) {
  setPlanes(w, choice);
}
template <PlanesChoice choice>
bool isChoice(const W& w) {
  return w.view.orientation.planes == choice;
}
template <Plane plane>
void turn(W& w) {
  turnView(w.view, w.viewFrame(), plane);
}

// clang-format off
const Command kCommands[] = {
  {"planes.automatic", "Automatic", Menu::view, {}, choose<PlanesChoice::automatic>, nullptr,
   isChoice<PlanesChoice::automatic>, true, kPlanesMenu},
  {"planes.patient", "Patient: axial, coronal, sagittal", Menu::view, {}, choose<PlanesChoice::patient>, nullptr,
   isChoice<PlanesChoice::patient>, false, kPlanesMenu},
  {"planes.scanner", "Scanner: A, B, C", Menu::view, {}, choose<PlanesChoice::scanner>, nullptr,
   isChoice<PlanesChoice::scanner>, false, kPlanesMenu},
  {"planes.turnAxial", "Clockwise in axial (A)", Menu::view, {}, turn<Plane::axial>, hasScan, nullptr, false, kTurn},
  {"planes.turnCoronal", "Clockwise in coronal (C)", Menu::view, {}, turn<Plane::coronal>, hasScan, nullptr, false, kTurn},
  {"planes.turnSagittal", "Clockwise in sagittal (B)", Menu::view, {}, turn<Plane::sagittal>, hasScan, nullptr, false, kTurn},
  {"planes.turnBack", "Not turned", Menu::view, {}, turnBack, isTurned, nullptr, false, kTurn},
  {"planes.mirror", "Mirror the scan: left and right (scan.mirror)", Menu::view, {}, mirror, hasScan, isMirrored, true, kTurn},
};
// clang-format on

}  // namespace

std::span<const Command> planeCommands() { return kCommands; }

}  // namespace sonoskin
