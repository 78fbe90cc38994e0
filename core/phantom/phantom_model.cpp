#include "core/phantom/phantom_model.h"

#include <cmath>

#include "core/phantom/fetal_body.h"
#include "core/phantom/fetal_head.h"
#include "core/phantom/hand_pose.h"
#include "core/phantom/random_field.h"
#include "core/phantom/scene_plan.h"

namespace sonoskin {
namespace {

using namespace sdf;

constexpr float kArmJoin = 1.2f;

float firstWall(const vec3& p) {
  const float folds =
      1.6f * std::sin(p.x / 17) + 1.3f * std::cos(p.z / 12) + 0.6f * std::sin((p.x + p.z) / 6);
  float d = (p.y - 8.5f - folds) * 0.96f;
  const float lobes = 0.6f * std::sin(p.x / 4.5f) * std::sin(p.z / 5);
  d = smoothMin(d, ellipsoid(p, {14, 4, 100}, {40, 16, 34}) + lobes, 4);  // placenta
  return smoothMin(d, -ellipsoid(p, {72, 66, 56}, {94, 72, 74}), 6);
}

// onFace: from the hairline to the chin and from cheek to cheek, seen from before the first head.
bool onFace(const vec3& p) {
  const float x = p.x / 31, y = (p.y + 7) / 34;
  return p.z > 8 && x * x + y * y < 1;
}

}  // namespace

PhantomModel::PhantomModel(const PhantomOptions& options) {
  const ScenePlan plan = planScene(options);
  pose_ = headPose(plan.turn, plan.centre);
  layTrunk(plan);
  layArms(plan, options.shape);
  attachLobes(plan.lobes);
  const std::uint32_t key = streamKey(options.seed, 42) ^ streamKey(options.shape, 43);
  if (plan.cordSide) layCord(plan.cordSide, key);
  if (plan.membranes) addMembranes(plan.membranes, key);
}

double PhantomModel::skin(const glm::dvec3& world) const { return double(skinOf(pose_.toHead(world))); }

double PhantomModel::bone(const glm::dvec3& world) const {
  const vec3 p = pose_.toHead(world);
  float d = std::min(headBone(p), bodyBone(toTrunk(p) / size_) * size_);
  if (isFirstArm_) return double(std::min(d, firstArmBone(p)));
  for (const Arm& arm : arms_) d = std::min(d, armBone(p, arm));
  return double(d);
}

double PhantomModel::wall(const glm::dvec3& world) const {
  constexpr float kJoin = 5;
  const vec3 p(world);
  float d = firstWall(p);
  for (const Lobe& lobe : lobes_) {
    if (!lobe.reach.joins(p, d, kJoin)) continue;
    const float bumps = 0.5f * std::sin(p.x / 4.5f) * std::sin(p.y / 4 + p.z / 5);
    d = smoothMin(d, chain(p, lobe.joints, 6) + bumps, kJoin);
  }
  return double(d);
}

double PhantomModel::strands(const glm::dvec3& world) const {
  return double(std::min(membraneDistance(membranes_, vec3(world)), cordDistance(cord_, vec3(world))));
}

double PhantomModel::other(const glm::dvec3& world) const { return std::min(wall(world), strands(world)); }

BodyPart PhantomModel::part(const glm::dvec3& world) const {
  const vec3 p = pose_.toHead(world), t = toTrunk(p) / size_;
  const float head = headSkin(p);
  float body = std::min(bodySkin(t), rightArmHangs_ ? rightArmSkin(t) : head) * size_;
  float hand = std::min(head, body) + 1;
  for (const Arm& arm : arms_) {
    body = std::min(body, upperArmSkin(p, arm));
    hand = std::min(hand, forearmSkin(p, arm));
  }
  if (hand < std::min(head, body)) return BodyPart::hand;
  if (body < head) return BodyPart::body;
  return onFace(p / size_) ? BodyPart::face : BodyPart::head;
}

BodyPart PhantomModel::partNear(const glm::dvec3& world) const {
  return std::abs(other(world)) < std::abs(skin(world)) ? BodyPart::other : part(world);
}

// The skin of the face at x to the baby's left and y upward, seen from before it.
FacePlaces PhantomModel::facePlaces() const {
  const auto at = [&](float x, float y) {
    constexpr float kBefore = 60, kCloseEnough = 1e-3f;
    vec3 p{x, y, kBefore};
    for (float d = headSkin(p); d > kCloseEnough && p.z > 0; d = headSkin(p)) p.z -= 0.7f * d;
    return pose_.toWorld(p);
  };
  return {at(-14.4f, -1.4f), at(14.4f, -1.4f), at(0, -12.6f), at(-11, -26.4f), at(11, -26.4f)};
}

float PhantomModel::headAndTrunk(const glm::vec3& p) const {
  const vec3 t = toTrunk(p) / size_;
  float body = bodySkin(t);
  if (rightArmHangs_) body = smoothMin(body, rightArmSkin(t), 4);
  return smoothMin(headSkin(p), body * size_, 5);
}

float PhantomModel::skinOf(const glm::vec3& p) const {
  float d = headAndTrunk(p);
  if (isFirstArm_) return smoothMin(d, firstArmSkin(p), kArmJoin);
  for (const Arm& arm : arms_) d = smoothMin(d, armSkin(p, arm), kArmJoin);
  return d;
}

void PhantomModel::layTrunk(const ScenePlan& plan) {
  const glm::mat3 turn(turnAbout(plan.trunkTurn));
  const vec3 neck = kNeck * size_;
  headToTrunk_ = turn;
  trunkShift_ = neck - turn * neck;
}

void PhantomModel::layArms(const ScenePlan& plan, int shape) {
  const Arm first = scaledArm(firstArm(), size_);
  const SkinFunction skin = [this](const vec3& p) { return headAndTrunk(p); };
  const auto shoulder = [&](bool right) {
    const vec3 t = kShoulder * size_ * vec3(right ? -1 : 1, 1, 1);
    return glm::transpose(headToTrunk_) * (t - trunkShift_);
  };
  for (const HandPlace& place : plan.hands) {
    arms_.push_back(reachFor(first, place, skin, shoulder(place.right)));
    if (place.right) rightArmHangs_ = false;
  }
  if (!arms_.empty()) return;
  arms_.push_back(first);
  isFirstArm_ = shape == 0 && plan.trunkTurn.yaw == 0;
  if (isFirstArm_) return;
  arms_[0].shoulder = shoulder(false);
  withdrawHand(arms_[0], skin, {0.35f, -0.2f, 1});
}

void PhantomModel::attachLobes(const std::vector<glm::vec3>& directions) {
  constexpr float kPressed = 1.2f, kWallDepth = 14;
  const SkinFunction skin = [this](const vec3& p) { return skinOf(p); };
  for (const vec3& direction : directions) {
    const vec3 under = skinToward(skin, vec3(0, -5, 5) * size_, direction);
    vec3 out = glm::normalize(glm::transpose(pose_.worldToHead) * slopeOf(skin, under));
    out = glm::normalize(out * vec3(1, 0.3f, 1));
    const vec3 tip = vec3(pose_.toWorld(under)) + out * (9 - kPressed);
    vec3 root = tip + out * 28.f;
    root.y = kWallDepth;
    const vec3 middle = 0.5f * (tip + root) + out * 6.f;
    const float reach = 0.5f * glm::distance(tip, root) + 26;
    lobes_.push_back({{{{tip, 9}, {middle, 12}, {root, 17}}}, {0.5f * (tip + root), reach}});
  }
}

void PhantomModel::addMembranes(int count, std::uint32_t key) {
  const SkinFunction skin = [this](const vec3& p) { return skinOf(p); };
  std::vector<vec3> starts, towards;
  std::uint32_t index = 0;
  const auto between = [&](float low, float high) { return low + (high - low) * uniformAt(index++, key); };
  for (int n = 0; n < count; ++n) {
    const vec3 direction(between(-0.75f, 0.75f), between(-0.7f, 0.6f), 0.8f);
    const vec3 lean = glm::normalize(vec3(between(-0.8f, 0.8f), -1, between(-0.8f, 0.8f)));
    const vec3 beside = n % 2 ? vec3(between(-0.1f, 0.1f), between(0.15f, 0.25f), 0) : vec3(0);
    for (int s = 0; s <= n % 2; ++s) {
      const vec3 at = skinToward(skin, vec3(0, -5, 5) * size_, direction + float(s) * beside);
      starts.push_back(vec3(pose_.toWorld(at)));
      towards.push_back(lean);
    }
  }
  membranes_ = spanMembranes(
      starts, towards, [this](const vec3& p) { return float(this->skin(p)); },
      [this](const vec3& p) { return float(wall(p)); }, key);
}

void PhantomModel::layCord(int side, std::uint32_t key) {
  const float radius = 5 + 2 * uniformAt(900, key), s = float(side), low = 6 * uniformAt(901, key);
  std::vector<vec3> guide{{s * 75, 5, 60},         {s * 58, -8, 42},        {s * 40, -8 - low, 20},
                          {s * 27, -20 - low, 28}, {s * 12, -42 - low, 26}, {-s * 12, -52 - low, 14},
                          {-s * 30, -64, 18},      {-s * 52, -76, 30},      {-s * 75, -86, 40}};
  const SkinFunction skin = [this](const vec3& p) { return skinOf(p); };
  for (std::size_t n = 0; n < guide.size(); ++n) {
    const bool lies = n > 1 && n + 2 < guide.size();
    vec3& p = guide[n] *= size_;
    for (int step = 0; step < 12; ++step) {
      const float d = skin(p) - 0.92f * radius;
      if (lies || d < 0) p -= slopeOf(skin, p) * (0.8f * d);
    }
    p = vec3(pose_.toWorld(p));
  }
  cord_ = makeCord(guide, radius);
}

}  // namespace sonoskin
