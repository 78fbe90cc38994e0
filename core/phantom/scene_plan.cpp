#include "core/phantom/scene_plan.h"

#include <cstdint>

#include "core/phantom/random_field.h"

namespace sonoskin {
namespace {

using glm::vec3;

// Draw: random numbers of one scene, one after the other.
class Draw {
 public:
  explicit Draw(const PhantomOptions& o)
      : key_(streamKey(o.seed, 40) ^ scramble(streamKey(o.shape, 41) + std::uint32_t(o.scene))) {}
  float between(float low, float high) { return low + (high - low) * uniformAt(index_++, key_); }
  double degrees(float low, float high) { return double(glm::radians(between(low, high))); }
  float side() { return between(-1, 1) < 0 ? -1.f : 1.f; }
  vec3 about(const vec3& v, float by) {
    return v + vec3(between(-by, by), between(-by, by), between(-by, by));
  }

 private:
  std::uint32_t key_, index_ = 0;
};

void turnLittle(ScenePlan& plan, Draw& draw) {
  plan.turn = {draw.degrees(-12, 12), draw.degrees(-5, 7), draw.degrees(-10, 10)};
  plan.centre = draw.about(plan.centre, 2);
}

// turnMuch: turns the head, and the trunk after it by about half.
void turnMuch(ScenePlan& plan, Draw& draw, float least, float most, float tilt) {
  const double yaw = double(draw.side()) * draw.degrees(least, most);
  plan.turn = {yaw, draw.degrees(-8, 12), draw.degrees(-tilt, tilt)};
  plan.trunkTurn = {-yaw * double(draw.between(0.3f, 0.6f)), 0, draw.degrees(-8, 8)};
  plan.centre = draw.about(plan.centre, 2);
}

HandPlace mirrored(HandPlace place) {
  place.knuckles.x *= -1;
  place.fingers.x *= -1;
  place.right = !place.right;
  return place;
}

std::vector<HandPlace> handsOf(int variant, Draw& draw) {
  const HandPlace cheek{draw.about({0.75f, -0.45f, 0.62f}, 0.05f), draw.about({-0.3f, 1, 0.1f}, 0.2f)};
  const HandPlace mouth{draw.about({0.42f, -0.66f, 0.75f}, 0.05f), draw.about({-0.9f, 0.75f, 0}, 0.2f)};
  switch (variant) {
    case 0:  // at the temple
      return {{draw.about({0.9f, 0.12f, 0.42f}, 0.06f), draw.about({-0.35f, 1, 0}, 0.2f)}};
    case 1:  // before the chin
      return {{draw.about({0.25f, -0.75f, 0.65f}, 0.06f), draw.about({-1, 0.35f, 0}, 0.2f)}};
    case 2:  // over an eye
      return {{draw.about({0.66f, -0.28f, 0.7f}, 0.05f), draw.about({-0.45f, 1, 0}, 0.15f)}};
    case 3:
      return {cheek, mirrored(cheek)};
    case 4:
      return {mouth, mirrored({draw.about({0.5f, -0.8f, 0.55f}, 0.05f), vec3(-0.5f, 1, 0)})};
    default:  // at the forehead
      return {{draw.about({0.62f, 0.35f, 0.7f}, 0.06f), draw.about({-1, 0.6f, 0}, 0.2f)}};
  }
}

void placeHands(ScenePlan& plan, Draw& draw, int seed) {
  plan.hands = handsOf(seed % 6, draw);
  if (draw.side() > 0) return;
  for (HandPlace& place : plan.hands) place = mirrored(place);
}

// Placenta and wall come from the side of the head that the probe sees less of.
void attach(ScenePlan& plan, Draw& draw) {
  const float side = plan.turn.yaw > 0 ? -1.f : 1.f;
  plan.lobes = {draw.about({side * 0.85f, -0.38f, 0.62f}, 0.06f),
                draw.about({side * 0.9f, 0.4f, 0.4f}, 0.07f),
                draw.about({side * 0.62f, -1.25f, 0.25f}, 0.07f)};
  plan.wallBack = 15;
  plan.membranes = 3 + int(draw.between(0, 2.99f));
}

}  // namespace

ScenePlan planScene(const PhantomOptions& options) {
  ScenePlan plan;
  Draw draw(options);
  switch (options.scene) {
    case PhantomScene::turned:
      turnMuch(plan, draw, 25, 60, 22);
      break;
    case PhantomScene::attached:
      turnLittle(plan, draw);
      attach(plan, draw);
      break;
    case PhantomScene::cord:
      turnLittle(plan, draw);
      plan.cordSide = int(draw.side());
      break;
    case PhantomScene::hands:
      turnLittle(plan, draw);
      placeHands(plan, draw, options.seed);
      break;
    case PhantomScene::clinical:
      turnMuch(plan, draw, 8, 35, 15);
      attach(plan, draw);
      break;
    default:
      break;
  }
  return plan;
}

}  // namespace sonoskin
