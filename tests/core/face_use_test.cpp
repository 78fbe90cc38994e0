#include "core/pipeline/face_use.h"

#include <gtest/gtest.h>

#include "core/phantom/phantom.h"
#include "core/pipeline/phantom_landmarks.h"
#include "core/pipeline/pipeline.h"

namespace sonoskin {
namespace {

using Place = std::array<double, 3>;

FaceFit someFace() {
  FaceFit face;
  face.confidence = 0.9f;
  face.headHeight = 90;
  face.places = {{1, 2, 3.04f}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}, {13, 14, 15}, {16, 17, 18}};
  return face;
}

TEST(FaceUse, FillsWhatWasNotGivenByHand) {
  const FaceFit face = someFace();
  Parameters p;
  p.landmarks.noseTip = {70, 80, 90};
  const LandmarkOptions all = landmarksWithFace(p, &face);
  EXPECT_EQ(all.noseTip, (Place{70, 80, 90})) << "by hand wins";
  EXPECT_EQ(all.rightEye, (Place{1, 2, 3})) << "to a tenth of a millimetre";
  EXPECT_EQ(all.mouthLeft, (Place{13, 14, 15}));
}

TEST(FaceUse, GuessesNothingWhereTheFaceIsUncertain) {
  FaceFit face = someFace();
  Parameters p;
  p.face.confidence = 0.95;
  EXPECT_EQ(landmarksWithFace(p, &face), LandmarkOptions{});
  EXPECT_EQ(landmarksWithFace(p, nullptr), LandmarkOptions{});
  EXPECT_NE(faceText(&face, p.face).find("no face"), std::string::npos);
  EXPECT_TRUE(faceText(nullptr, p.face).empty());
  face.headHeight = 20;
  EXPECT_TRUE(scaleWarning(&face, p.face).empty()) << "an uncertain face tells nothing of the scale";
  face.confidence = 0;
  p.face.confidence = 0;
  EXPECT_FALSE(isCertain(&face, p.face)) << "nothing was found";
}

TEST(FaceUse, AsksForTheSpacingWhereTheHeadHasNoHeadsSize) {
  FaceFit face = someFace();
  EXPECT_TRUE(scaleWarning(&face, {}).empty());
  face.headHeight = 30;
  EXPECT_NE(scaleWarning(&face, {}).find("30 mm"), std::string::npos);
  face.headHeight = 300;
  EXPECT_FALSE(scaleWarning(&face, {}).empty());
}

// The whole way: a simulated scan, and where its face is.
TEST(FaceUse, ThePipelineFindsTheFaceOfASimulatedScan) {
  Parameters p;
  p.phantom.dims = {200, 110, 80};
  const Scan scan = makePhantomScan(p.phantom);
  const Results results = Pipeline().run(scan, p, Goal::mesh);
  ASSERT_TRUE(isCertain(results.face.get(), p.face));
  const LandmarkOptions truth = phantomLandmarks(), found = landmarksWithFace(p, results.face.get());
  const auto off = [](const Place& a, const Place& b) {
    return glm::distance(glm::dvec3(a[0], a[1], a[2]), glm::dvec3(b[0], b[1], b[2]));
  };
  EXPECT_LT(off(found.rightEye, truth.rightEye), 2.5);
  EXPECT_LT(off(found.leftEye, truth.leftEye), 2.5);
  EXPECT_LT(off(found.noseTip, truth.noseTip), 2);
  EXPECT_LT(off(found.mouthRight, truth.mouthRight), 2.5);
  EXPECT_LT(off(found.mouthLeft, truth.mouthLeft), 2.5);
  EXPECT_NEAR(results.face->headHeight, 92, 9);
  p.face.find = false;
  EXPECT_EQ(Pipeline().run(scan, p, Goal::mesh).face, nullptr);
}

}  // namespace
}  // namespace sonoskin
