#include "tests/support/first_phantom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace sonoskin {
namespace {

using glm::dvec3;
using Distance = double (*)(const dvec3&);

dvec3 gradientOf(Distance f, const dvec3& p) {
  dvec3 g;
  for (int axis = 0; axis < 3; ++axis) {
    dvec3 h(0);
    h[axis] = 0.02;
    g[axis] = (f(p + h) - f(p - h)) / 0.04;
  }
  return g;
}

class Places {
 public:
  dvec3 next() { return dvec3(uniform_(engine_), uniform_(engine_), uniform_(engine_)) * kFieldOfView; }

 private:
  std::mt19937 engine_{7};
  std::uniform_real_distribution<double> uniform_{0, 1};
};

// firstHit: depth y at which a line from the probe's side meets the skin.
double firstHit(double x, double z) {
  double y = 12;
  while (y < 75 && test::skinDistance({x, y, z}) > 0.005)
    y += std::max(0.004, 0.7 * test::skinDistance({x, y, z}));
  return y;
}

TEST(FetalFace, IsADistanceNearTheSkin) {
  Places places;
  std::vector<double> atSkin;
  int steep = 0, near = 0;
  for (int n = 0; n < 400000; ++n) {
    const dvec3 p = places.next();
    const double d = test::skinDistance(p);
    if (std::abs(d) > 3) continue;
    const double slope = glm::length(gradientOf(test::skinDistance, p));
    ++near;
    steep += slope > 1.25;
    if (std::abs(d) < 0.3) atSkin.push_back(slope);
  }
  ASSERT_GT(near, 20000);
  EXPECT_LT(steep, near / 1000);
  std::sort(atSkin.begin(), atSkin.end());
  EXPECT_NEAR(atSkin[atSkin.size() / 2], 1, 0.02);
  EXPECT_GT(atSkin[atSkin.size() / 12], 0.8);  // creases are the rest
  EXPECT_LT(atSkin[atSkin.size() - 1 - atSkin.size() / 200], 1.2);
}

TEST(FetalFace, HasNoJumps) {
  Places places;
  int near = 0;
  for (int n = 0; n < 200000; ++n) {
    const dvec3 p = places.next(), q = p + 0.002 * (places.next() / kFieldOfView - 0.5);
    const double d = test::skinDistance(p);
    if (d > -4 && d < 8) {
      ++near;
      ASSERT_LT(std::abs(test::skinDistance(q) - d), 0.006) << p.x << ' ' << p.y << ' ' << p.z;
    }
  }
  EXPECT_GT(near, 20000);
}

TEST(FetalFace, HeadIsAbout75MillimetresAcross) {
  double width = 0;
  for (double x = 34; x < 44; x += 1) {
    double low = 56, high = 56;
    while (test::skinDistance({x, 73, low}) < 0) low -= 0.1;
    while (test::skinDistance({x, 73, high}) < 0) high += 0.1;
    width = std::max(width, high - low);
  }
  EXPECT_NEAR(width, 75, 3);
}

TEST(FetalFace, ProfileRunsFromForeheadOverNoseAndLipsToChin) {
  const auto profile = [](double x) {  // the most forward skin near the middle of the face
    double least = 1e9;
    for (double z = 46; z < 55; z += 0.5) least = std::min(least, firstHit(x, z));
    return least;
  };
  const double forehead = profile(38), root = profile(56), tip = profile(68), base = profile(74),
               lips = profile(80);
  EXPECT_GT(root - forehead, 1);
  EXPECT_GT(root - tip, 4);
  EXPECT_GT(base - tip, 3);
  EXPECT_GT(base - lips, 0.5);
  EXPECT_GT(lips - tip, 1);
}

TEST(FetalFace, FourFingersAreSeenApart) {
  std::vector<double> depth;
  for (double z = 57; z < 88; z += 0.25) depth.push_back(firstHit(88, z));
  int ridges = 0;
  constexpr std::ptrdiff_t kApart =
      7;  // samples: within 1.75 mm it is the most forward, and grooves lie beside it
  for (auto at = depth.begin() + kApart; at < depth.end() - kApart; ++at) {
    const bool foremost = std::min_element(at - kApart, at + kApart + 1) == at;
    ridges += foremost && at[-kApart] > *at + 0.3 && at[kApart] > *at + 0.3;
  }
  EXPECT_EQ(ridges, 4);
}

TEST(FetalFace, BonesLieUnderTheSkin) {
  Places places;
  int inBone = 0;
  for (int n = 0; n < 200000; ++n) {
    const dvec3 p = places.next();
    if (test::boneDistance(p) > 0) continue;
    ++inBone;
    ASSERT_LT(test::skinDistance(p), -0.5) << p.x << ' ' << p.y << ' ' << p.z;
  }
  EXPECT_GT(inBone, 1000);
}

TEST(FetalFace, FluidSeparatesTheFaceFromTheWall) {
  int onFace = 0;
  for (double x = 30; x < 100; x += 2)
    for (double z = 35; z < 90; z += 2) {
      const double y = firstHit(x, z);
      if (y < 45) {
        ++onFace;
        EXPECT_GT(test::wallDistance({x, y, z}), 4) << x << ' ' << z;
      }
    }
  EXPECT_GT(onFace, 100);
  EXPECT_LT(test::wallDistance({70, 3, 56}), 0);
}

// The places are the skin's own, and lie to each other as in a face that looks at the probe with its head toward -x.
TEST(FetalFace, ItsPlacesLieOnTheSkin) {
  const FacePlaces f = test::firstPhantom().facePlaces();
  for (const dvec3& p : {f.rightEye, f.leftEye, f.noseTip, f.mouthRight, f.mouthLeft})
    EXPECT_NEAR(test::skinDistance(p), 0, 0.05);
  EXPECT_NEAR(glm::distance(f.rightEye, f.leftEye), 28.8, 0.5);
  EXPECT_NEAR(glm::distance(f.mouthRight, f.mouthLeft), 22, 0.5);
  EXPECT_GT(f.leftEye.z, f.rightEye.z + 25) << "z points to the baby's left";
  EXPECT_GT(f.mouthLeft.z, f.mouthRight.z + 18);
  EXPECT_GT(f.mouthLeft.x, f.leftEye.x + 15) << "x points to the feet";
  const dvec3 middle = (f.rightEye + f.leftEye + f.mouthRight + f.mouthLeft) / 4.0;
  EXPECT_LT(f.noseTip.y, middle.y - 5) << "the nose is nearer to the probe";
}

}  // namespace
}  // namespace sonoskin
