#include "core/mesh/parts/choose_parts.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/mesh/components.h"
#include "core/mesh/parts/split_part.h"
#include "core/pipeline/kept_parts.h"
#include "tests/support/solids.h"

namespace sonoskin {
namespace {

using test::ball;
using test::rod;
using test::solid;

// Seen by parallel beams along +y: a head in the middle, a hand that touches it by a strand, a ball far behind, a speck,
// and a large flat sheet before the head's edge, all as pieces of one surface.
const glm::vec3 kHead{0, -28, 0}, kHand{40, -16, 0}, kFar{30, 110, 30}, kSpeck{0, -34, 44},
    kSheet{-52, -45, 0};

Mesh movedBy(Mesh mesh, const glm::vec3& by) {
  for (glm::vec3& x : mesh.positions) x += by;
  return mesh;
}

std::vector<Mesh> scene() {
  const Mesh baby = solid(
      [](const glm::dvec3& x) {
        return std::min(
            {ball(x, {0, 0, 0}, 28), ball(x, {40, 0, 0}, 16), rod(x, {0, 0, 0}, {40, 0, 0}, 1.5)});
      },
      {58, 30, 30}, 0.8);
  const Mesh far = movedBy(solid(
                               [](const glm::dvec3& x) {
                                 return ball(x, {0, 0, 0}, 12);
                               },
                               {14, 14, 14}, 0.8),
                           {30, 122, 30});
  const Mesh speck = movedBy(solid(
                                 [](const glm::dvec3& x) {
                                   return ball(x, {0, 0, 0}, 2);
                                 },
                                 {4, 4, 4}, 0.4),
                             {0, -32, 44});
  Mesh sheet;
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 100; ++j)
      sheet.positions.push_back({0.7f * float(i) - 70, -45, 0.7f * float(j) - 35});
  for (std::uint32_t i = 0; i < 60; ++i)
    for (std::uint32_t j = 0; j < 100; ++j) {
      const std::uint32_t a = i * 101 + j, b = a + 101;
      sheet.triangles.push_back({a, b, b + 1});
      sheet.triangles.push_back({a, b + 1, a + 1});
    }
  computeNormals(sheet);
  return {baby, sheet, far, speck};
}

struct ChooseParts : testing::Test {
  const std::vector<Mesh> pieces = scene();
  const PartedSurface surface = partSurface(pieces, {});
  PartView view{Beam{{}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}, 0.08, {}};

  PartVerdict at(const glm::vec3& place, const std::vector<PartVerdict>& verdicts) const {
    return verdicts[partAt(surface.mesh, surface.parts, place)];
  }
  PartReason reason(const glm::vec3& place) const {
    return at(place, chooseParts(surface.mesh, surface.parts, view)).reason;
  }
};

TEST_F(ChooseParts, KeepsFaceAndHandAndNothingElse) {
  const auto verdicts = chooseParts(surface.mesh, surface.parts, view);
  EXPECT_EQ(reason(kHead), PartReason::face);
  EXPECT_EQ(reason(kHand), PartReason::beside);
  EXPECT_EQ(reason(kFar), PartReason::far);
  EXPECT_EQ(reason(kSheet), PartReason::wall);
  EXPECT_NE(reason(kSpeck), PartReason::beside);
  EXPECT_EQ(std::count_if(verdicts.begin(), verdicts.end(), [](const PartVerdict& v) { return v.kept; }), 2);
  EXPECT_EQ(at(kHead, verdicts).share, 1);
  EXPECT_LT(at(kHand, verdicts).share, at(kHand, verdicts).seen);  // it lies off the middle
}

TEST_F(ChooseParts, ALargerShareLeavesTheFaceAlone) {
  view.companions = 1;
  EXPECT_EQ(reason(kHead), PartReason::face);
  EXPECT_FALSE(at(kHand, chooseParts(surface.mesh, surface.parts, view)).kept);
}

// A face's skin as it is expected: the side of a ball that faces the probe.
FaceSite faceOn(const glm::vec3& centre, float radius) {
  FaceSite face{{}, {}, centre, {0, 0, 1}, {0, -1, 0}, 2.4f * radius};
  for (int i = -60; i <= 60; i += 10)
    for (int j = -60; j <= 60; j += 10) {
      const float u = glm::radians(float(i)), v = glm::radians(float(j));
      const glm::vec3 out(std::sin(u) * std::cos(v), -std::cos(u) * std::cos(v), std::sin(v));
      face.places.push_back(centre + radius * out);
      face.normals.push_back(out);
    }
  return face;
}

TEST_F(ChooseParts, AFaceThatWasFoundDecides) {
  view.face = faceOn({40, 0, 0}, 16);
  EXPECT_EQ(reason(kHand), PartReason::face);
  view.face = faceOn({0, 200, 0}, 16);  // where no part lies
  EXPECT_EQ(reason(kHead), PartReason::face);
}

// The same ball is a hand before the face, or below it, and something else beside the crown.
TEST_F(ChooseParts, NoLimbLiesBesideTheCrown) {
  view.face = faceOn({0, 0, 0}, 28);
  EXPECT_EQ(reason(kHand), PartReason::aside);
  view.face->ears = {0, 30, 0};  // the head lies deeper: the hand is before it
  EXPECT_EQ(reason(kHand), PartReason::beside);
  view.face->ears = {0, 0, 40};  // the head lies higher
  EXPECT_EQ(reason(kHand), PartReason::beside);
}

// Half of a face behind a gap, such as a chin below a deep mouth: alone in the view it would be aside.
TEST(ChoosePartsOnFace, KeepsWhatLiesOnTheFace) {
  const auto cap = [](float low, float high) {  // a strip of the ball's front between two heights
    Mesh strip;
    constexpr int kAcross = 80, kUp = 60;
    for (int i = 0; i <= kAcross; ++i)
      for (int j = 0; j <= kUp; ++j) {
        const float u = glm::radians(-60 + 120.f * float(i) / kAcross),
                    z = low + (high - low) * float(j) / kUp;
        const float r = std::sqrt(30 * 30 - z * z);
        strip.positions.push_back({r * std::sin(u), -r * std::cos(u), z});
      }
    for (std::uint32_t i = 0; i < kAcross; ++i)
      for (std::uint32_t j = 0; j < kUp; ++j) {
        const std::uint32_t a = i * (kUp + 1) + j, b = a + kUp + 1;
        strip.triangles.push_back({a, b, b + 1});
        strip.triangles.push_back({a, b + 1, a + 1});
      }
    computeNormals(strip);
    return strip;
  };
  const Mesh above = cap(-8, 28), chin = cap(-22, -13);
  const PartedSurface surface = partSurface({above, chin}, {});
  PartView view{Beam{{}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}, 0.5, {}};
  const auto verdictOfChin = [&] {
    return chooseParts(surface.mesh, surface.parts, view)[partAt(surface.mesh, surface.parts, {0, -24, -17})];
  };
  EXPECT_FALSE(verdictOfChin().kept);
  view.face = faceOn({0, 0, 0}, 30);
  EXPECT_EQ(verdictOfChin().reason, PartReason::onFace);
  EXPECT_TRUE(verdictOfChin().kept);
}

TEST_F(ChooseParts, PlacesBringPartsBackAndTakeThemAway) {
  MeshOptions options;
  const auto kept = [&](const glm::vec3& place) {
    return at(place, keepAsAsked(surface, options, view).verdicts);
  };
  options.partsAdd = {{30, 110, 30}};
  options.partsDrop = {{40, -16, 0}};
  EXPECT_EQ(kept(kFar).reason, PartReason::asked);
  EXPECT_TRUE(kept(kFar).kept);
  EXPECT_EQ(kept(kHand).reason, PartReason::dropped);
  EXPECT_FALSE(kept(kHand).kept);
  EXPECT_TRUE(kept(kHand).proposed);
  EXPECT_FALSE(kept(kFar).proposed);
  EXPECT_EQ(kept(kHead).reason, PartReason::face);
  options.parts = PartsChoice::all;
  EXPECT_EQ(kept(kSheet).reason, PartReason::all);
  EXPECT_FALSE(kept(kHand).kept);
  options = {};
  const double both = surfaceArea(keepAsAsked(surface, options, view).mesh);
  options.partsDrop = {{0, -28, 0}, {40, -16, 0}};
  EXPECT_THROW(keepAsAsked(surface, options, view), Error);
  EXPECT_NEAR(both, 4 * 3.1416 * (28 * 28 + 16 * 16), 0.05 * both);
}

TEST_F(ChooseParts, AStrokeInTheOptionsSplits) {
  MeshOptions options;
  options.partsCut = {{-26, -10, 0}, {26, -10, 0}, {0, -200, 0}};
  const PartedSurface split = partSurface(pieces, options);
  EXPECT_EQ(split.parts.parts.size(), surface.parts.parts.size() + 1);
  EXPECT_NE(partAt(split.mesh, split.parts, {0, -20, 19}), partAt(split.mesh, split.parts, {0, -20, -19}));
  EXPECT_THROW(partSurface({}, options), Error);
}

}  // namespace
}  // namespace sonoskin
