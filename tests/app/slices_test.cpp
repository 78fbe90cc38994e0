// Slices without a window: the cross-hair's steps and grey windows.
#include <gtest/gtest.h>

#include "app/workspace/cursor_steps.h"
#include "app/workspace/grey_windows.h"

namespace sonoskin {
namespace {

Geometry headFirst() {
  Geometry g;
  g.dims = {20, 30, 40};
  g.spacing = {0.5, 0.7, 1.1};
  g.direction = glm::dmat3(glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, -1));
  return g;
}

// Whatever the order of the voxels, a step to the right in the axial picture is one toward the patient's left.
TEST(CursorSteps, GoByVoxelsAsThePictureShowsThem) {
  const Geometry g = headFirst();
  ViewState view;
  view.planes = planeAxes(g, patientFrame());
  view.cursor = g.toWorld({10, 15, 20});
  const glm::dvec3 start = view.cursor;
  stepCursor(view, g, Plane::axial, {1, 0, 0});
  EXPECT_NEAR(view.cursor.x - start.x, 0.5, 1e-9);
  stepCursor(view, g, Plane::axial, {0, -1, 0});
  EXPECT_NEAR(view.cursor.y - start.y, -0.7, 1e-9);
  stepCursor(view, g, Plane::axial, {0, 0, 1});
  EXPECT_NEAR(view.cursor.z - start.z, 1.1, 1e-9) << "toward the head";
  stepCursor(view, g, Plane::coronal, {0, 0, 1000});
  EXPECT_NEAR(g.toIndex(view.cursor).y, 0, 1e-9) << "toward the front, and not beyond the volume";
}

TEST(GreyWindows, AutomaticLeavesOnePercentAtEitherEnd) {
  Geometry g;
  g.dims = {100, 100, 10};
  Volume<float> volume(g);
  for (std::size_t i = 0; i < volume.data.size(); ++i)
    volume.data[i] = float(i) / float(volume.data.size() - 1);
  const GreyWindow window = automaticWindow(volume);
  EXPECT_NEAR(window.level - window.width / 2, 0.01, 1e-4);
  EXPECT_NEAR(window.level + window.width / 2, 0.99, 1e-4);
  EXPECT_GT(automaticWindow(Volume<float>(g, 0.3f)).width, 0) << "of a volume without contrast";
}

TEST(GreyWindows, HounsfieldUnitsAreThoseOfTheFile) {
  Scan scan;
  scan.modality = "CT";
  scan.originalMin = -1000;
  scan.originalMax = 3000;
  const GreyWindow soft = hounsfieldWindow(scan, 40, 400);
  EXPECT_FLOAT_EQ(soft.level, 0.26f);
  EXPECT_FLOAT_EQ(soft.width, 0.1f);
  EXPECT_EQ(windowText(scan, soft), "window 400   level 40");
  scan.originalMin = 0;  // stored with 1024 added
  scan.originalMax = 4000;
  EXPECT_FLOAT_EQ(hounsfieldWindow(scan, 40, 400).level, 0.266f);
  EXPECT_TRUE(isCt(scan));
  scan.modality = "US";
  EXPECT_FALSE(isCt(scan));
}

}  // namespace
}  // namespace sonoskin
