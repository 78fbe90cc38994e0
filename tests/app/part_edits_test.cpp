#include "app/document/part_edits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/components.h"
#include "tests/support/solids.h"

namespace sonoskin {
namespace {

using test::ball;
using test::rod;
using test::solid;

// A head, a hand on a strand beside it, and a ball far behind, seen along +y.
struct PartEdits : testing::Test {
  const std::vector<Mesh> pieces{solid(
      [](const glm::dvec3& x) {
        return std::min({ball(x, {0, 0, 0}, 28), ball(x, {46, 0, 0}, 16), rod(x, {0, 0, 0}, {46, 0, 0}, 1.5),
                         ball(x, {0, 60, 0}, 12)});
      },
      {64, 76, 30}, 1.0)};
  const PartView view{Beam{{}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}, 0.08, {}, {}};
  MeshOptions options = withCompanions(0.05);
  Results results = make(options);

  static MeshOptions withCompanions(double share) {
    MeshOptions o;
    o.companions = share;
    return o;
  }
  Results make(const MeshOptions& o) const {
    Results made;
    made.parts = std::make_shared<const PartedSurface>(partSurface(splitPieces(pieces[0]), o));
    PartView asked = view;
    asked.companions = o.companions;
    made.verdicts =
        std::make_shared<const std::vector<PartVerdict>>(keepAsAsked(*made.parts, o, asked).verdicts);
    return made;
  }
  void apply(const MeshOptions& changed) {
    options = changed;
    results = make(options);
  }
  PartPick at(const glm::vec3& from) const {
    const auto pick = pickPart(results, from, {0, 1, 0});
    EXPECT_TRUE(pick);
    return pick.value_or(PartPick{});
  }
  bool isKept(const glm::vec3& from) const { return (*results.verdicts)[at(from).part].kept; }
  std::ptrdiff_t kept() const {
    return std::count_if(results.verdicts->begin(), results.verdicts->end(),
                         [](const PartVerdict& v) { return v.kept; });
  }
};

const glm::vec3 kFace{1.3f, -80, 0.7f}, kHand{47.3f, -80, 0.7f}, kBehind{1.3f, 40, 0.7f};

TEST_F(PartEdits, AClickTakesAwayAndBringsBackWithoutATrace) {
  ASSERT_TRUE(isKept(kFace) && isKept(kHand) && !isKept(kBehind));
  apply(*togglePart(results, options, at(kHand)));
  EXPECT_FALSE(isKept(kHand));
  EXPECT_EQ(options.partsDrop.size(), 1u);
  apply(*togglePart(results, options, at(kBehind)));
  EXPECT_TRUE(isKept(kBehind));
  EXPECT_EQ(options.partsAdd.size(), 1u);
  apply(*togglePart(results, options, at(kHand)));
  apply(*togglePart(results, options, at(kBehind)));
  EXPECT_TRUE(isKept(kHand) && !isKept(kBehind));
  EXPECT_TRUE(options.partsAdd.empty() && options.partsDrop.empty());
}

TEST_F(PartEdits, TheLastPartStays) {
  apply(*togglePart(results, options, at(kHand)));
  EXPECT_EQ(kept(), 1);
  EXPECT_FALSE(togglePart(results, options, at(kFace)));
}

TEST_F(PartEdits, OneAlone) {
  apply(*togglePart(results, options, at(kBehind)));
  EXPECT_EQ(kept(), 3);
  apply(faceAlone(results, options));
  EXPECT_EQ(kept(), 1);
  EXPECT_TRUE(isKept(kFace));
  apply(partAlone(results, options, at(kHand)));
  EXPECT_EQ(kept(), 1);
  EXPECT_TRUE(isKept(kHand));
  apply(faceAlone(results, options));
  EXPECT_TRUE(isKept(kFace) && !isKept(kHand));
}

TEST_F(PartEdits, ALineSplitsThePartThatItCrosses) {
  // From beside the head to beyond it: the stroke begins and ends on it.
  const glm::vec3 eye{0, -200, 0};
  const auto rayAt = [&](float t) { return glm::normalize(glm::vec3(0, 0, 40 - 80 * t) - eye); };
  const auto stroke = strokeAcross(results, eye, rayAt);
  ASSERT_TRUE(stroke);
  EXPECT_LT(glm::length(stroke->from), 30);
  EXPECT_GT(stroke->from.z, 20);
  EXPECT_LT(stroke->to.z, -20);
  const std::size_t before = results.parts->parts.parts.size();
  apply(addStroke(options, *stroke));
  EXPECT_EQ(results.parts->parts.parts.size(), before + 1);
  EXPECT_NE(at({-15, -80, 0}).part, at({15, -80, 0}).part);
  EXPECT_EQ(at({15, -80, 0}).part, at({15, -80, 12}).part);
  const auto beside = [&](float) { return glm::vec3(-1, 0, 0); };
  EXPECT_FALSE(strokeAcross(results, eye, beside));
}

}  // namespace
}  // namespace sonoskin
