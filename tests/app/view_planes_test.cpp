#include "app/document/view_planes.h"

#include <gtest/gtest.h>

#include "app/views/orientation_cube.h"
#include "app/workspace/view_state.h"

namespace sonoskin {
namespace {

Scan scanOf(const std::string& modality) {
  Scan scan;
  Geometry g;
  g.dims = {8, 9, 10};
  scan.volume = std::make_shared<const Volume<float>>(g);
  scan.modality = modality;
  return scan;
}

void expectNear(const glm::vec3& a, const glm::vec3& b) { EXPECT_LT(glm::distance(a, b), 1e-5f); }

TEST(ViewPlanes, FollowFromWhatIsKnownOfTheScan) {
  EXPECT_TRUE(decidePlanes(scanOf("CT")).isPatient);
  EXPECT_TRUE(decidePlanes(scanOf("MR")).isPatient);
  EXPECT_FALSE(decidePlanes(scanOf("US")).isPatient);
  EXPECT_FALSE(decidePlanes(scanOf("")).isPatient);
  Scan scan = scanOf("");
  scan.originalMin = -1024;
  EXPECT_TRUE(decidePlanes(scan).isPatient) << "Hounsfield units";
  scan.beam = Beam{};
  EXPECT_FALSE(decidePlanes(scan).isPatient) << "beams";
  const std::string reason = decidePlanes(scan).reason;
  EXPECT_EQ(reason.back(), '.');
  EXPECT_GT(reason.size(), 20u);
}

TEST(ViewPlanes, APersonHasTheLastWord) {
  const Scan ct = scanOf("CT"), us = scanOf("US");
  EXPECT_FALSE(viewFrameOf(ct, {}, {.planes = PlanesChoice::scanner}).isPatient);
  EXPECT_TRUE(viewFrameOf(us, {}, {.planes = PlanesChoice::patient}).isPatient);
}

TEST(ViewPlanes, ThreeDLooksAtThePatientFromTheFrontAndOtherwiseFromTheProbe) {
  ViewState view;
  resetView(view, scanOf("CT"), {});
  expectNear(view.camera.forward, {0, 1, 0});
  expectNear(view.camera.up, {0, 0, 1});
  const Beam beam{.apex = {}, .axis = {0, 0, 1}, .up = {0, -1, 0}};
  resetView(view, scanOf("US"), beam);
  expectNear(view.camera.forward, {0, 0, 1});
  expectNear(view.camera.up, {0, -1, 0});
  EXPECT_EQ(view.planes[Plane::coronal].across, 2) << "C is of constant depth";
}

// The coronal picture and 3D show the patient from the front: turned clockwise, both have the right-hand side on top.
TEST(ViewPlanes, TurningTurnsSlicesAndCameraAlike) {
  const Scan scan = scanOf("CT");
  ViewState view;
  resetView(view, scan, {});
  turnView(view, viewFrameOf(scan, {}, view.orientation), Plane::coronal);
  expectNear(view.camera.forward, {0, 1, 0});
  expectNear(view.camera.up, {-1, 0, 0});
  turnView(view, viewFrameOf(scan, {}, view.orientation), Plane::axial);
  const Camera turned = view.camera;
  const ViewFrame frame = viewFrameOf(scan, {}, view.orientation);
  resetCamera(view, frame, worldBox(scan.volume->geometry));
  expectNear(view.camera.forward, turned.forward);
  expectNear(view.camera.up, turned.up);
}

TEST(OrientationCube, SidesAreLookedAtUpright) {
  const ViewFrame frame = patientFrame();
  Camera camera;
  ui::lookFrom({1, 0, 0}, frame, camera);  // from the patient's left
  expectNear(camera.forward, {-1, 0, 0});
  expectNear(camera.up, {0, 0, 1});
  ui::lookFrom({0, 0, 1}, frame, camera);
  expectNear(camera.forward, {0, 0, -1});
  expectNear(camera.up, {0, -1, 0});
}

}  // namespace
}  // namespace sonoskin
