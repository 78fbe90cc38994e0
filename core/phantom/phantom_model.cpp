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

}  // namespace

PhantomModel::PhantomModel(const PhantomOptions& options) {
  const ScenePlan plan = planScene(options);
  pose_ = headPose(plan.turn, plan.centre);
  shape_ = sonoskin::headShape(options.shape);
  wallBack_ = plan.wallBack;
  measureFace();
  layTrunk(plan);
  layArms(plan);
  attachLobes(plan.lobes);
  const std::uint32_t key = streamKey(options.seed, 42) ^ streamKey(options.shape, 43);
  if (plan.cordSide) layCord(plan.cordSide, key);
  if (plan.membranes && !lobes_.empty()) addMembranes(plan.membranes, key);
}

double PhantomModel::skin(const glm::dvec3& world) const { return double(skinOf(pose_.toHead(world))); }

double PhantomModel::bone(const glm::dvec3& world) const {
  const vec3 p = pose_.toHead(world);
  float d = std::min(headBone(p, shape_), bodyBone(toTrunk(p) / shape_.size) * shape_.size);
  if (isFirstArm_) return double(std::min(d, firstArmBone(p)));
  for (const Arm& arm : arms_) d = std::min(d, armBone(p, arm));
  return double(d);
}

double PhantomModel::wall(const glm::dvec3& world) const {
  constexpr float kJoin = 5;
  const vec3 p(world);
  float d = firstWall(p + vec3(0, wallBack_, 0));
  for (const Lobe& lobe : lobes_) {
    if (!lobe.reach.joins(p, d, kJoin)) continue;
    const float bumps = 0.8f * std::sin(p.x / 4.5f) * std::sin(p.y / 4 + p.z / 5);
    d = smoothMin(d, chain(p, lobe.joints, 6) + bumps, kJoin);
  }
  return double(d);
}

double PhantomModel::strands(const glm::dvec3& world) const {
  return double(std::min(membraneDistance(membranes_, vec3(world)), cordDistance(cord_, vec3(world))));
}

double PhantomModel::other(const glm::dvec3& world) const { return std::min(wall(world), strands(world)); }

BodyPart PhantomModel::part(const glm::dvec3& world) const {
  const vec3 p = pose_.toHead(world), t = toTrunk(p) / shape_.size;
  const float head = headSkin(p, shape_);
  float body = bodySkin(t) * shape_.size;
  if (rightArmHangs_) body = std::min(body, rightArmSkin(t) * shape_.size);
  float hand = std::min(head, body) + 1;
  for (const Arm& arm : arms_) {
    body = std::min(body, upperArmSkin(p, arm));
    hand = std::min(hand, forearmSkin(p, arm));
  }
  if (hand < std::min(head, body)) return BodyPart::hand;
  if (body < head) return BodyPart::body;
  return onFace(p) ? BodyPart::face : BodyPart::head;
}

FacePlaces PhantomModel::facePlaces() const {
  const HeadPlaces h = headPlaces(shape_);
  return {pose_.toWorld(h.rightEye), pose_.toWorld(h.leftEye), pose_.toWorld(h.noseTip),
          pose_.toWorld(h.mouthRight), pose_.toWorld(h.mouthLeft)};
}

void PhantomModel::measureFace() {
  constexpr float kEyes = 28.8f, kEyeToChin = 33.4f;  // of the first head
  const HeadPlaces h = headPlaces(shape_);
  eyes_ = 0.5f * (h.rightEye + h.leftEye);
  faceScale_ = {(h.leftEye.x - h.rightEye.x) / kEyes, (eyes_.y - h.chin.y) / kEyeToChin, shape_.size};
}

// onFace: whether a place of the head is seen from before it between hairline and chin, cheek and cheek.
bool PhantomModel::onFace(const glm::vec3& p) const {
  const float x = (p.x - eyes_.x) / (31 * faceScale_.x), y = ((p.y - eyes_.y) / faceScale_.y + 5.6f) / 34;
  return p.z > 8 * faceScale_.z && x * x + y * y < 1;
}

float PhantomModel::headAndTrunk(const glm::vec3& p) const {
  const vec3 t = toTrunk(p) / shape_.size;
  float body = bodySkin(t);
  if (rightArmHangs_) body = smoothMin(body, rightArmSkin(t), 4);
  return smoothMin(headSkin(p, shape_), body * shape_.size, 5);
}

float PhantomModel::skinOf(const glm::vec3& p) const {
  float d = headAndTrunk(p);
  if (isFirstArm_) return smoothMin(d, firstArmSkin(p), kArmJoin);
  for (const Arm& arm : arms_) d = smoothMin(d, armSkin(p, arm), kArmJoin);
  return d;
}

void PhantomModel::layTrunk(const ScenePlan& plan) {
  const glm::mat3 turn(turnAbout(plan.trunkTurn));
  const vec3 neck = kNeck * shape_.size;
  headToTrunk_ = turn;
  trunkShift_ = neck - turn * neck;
}

void PhantomModel::layArms(const ScenePlan& plan) {
  const Arm first = scaledArm(firstArm(), shape_.size);
  const SkinFunction skin = [this](const vec3& p) { return skinOf(p); };  // with the arms so far
  const auto shoulder = [&](bool right) {
    const vec3 t = kShoulder * shape_.size * vec3(right ? -1 : 1, 1, 1);
    return glm::transpose(headToTrunk_) * (t - trunkShift_);
  };
  for (const HandPlace& place : plan.hands) {
    arms_.push_back(reachFor(first, place, skin, shoulder(place.right)));
    if (place.right) rightArmHangs_ = false;
  }
  if (!arms_.empty()) return;
  Arm arm = first;
  isFirstArm_ = shape_ == HeadShape{} && plan.trunkTurn.yaw == 0;
  if (!isFirstArm_) {
    arm.shoulder = shoulder(false);
    withdrawHand(arm, skin, {0.35f, -0.2f, 1});
  }
  arms_.push_back(arm);
}

// Each lobe is a stump between the skin and the wall; ridges join their middles.
void PhantomModel::attachLobes(const std::vector<glm::vec3>& directions) {
  constexpr float kPressed = 1.5f, kTip = 8, kMiddle = 11, kRoot = 16, kRootDepth = 2, kMargin = 8;
  const SkinFunction skin = [this](const vec3& p) { return skinOf(p); };
  const auto add = [&](const Joint& a, const Joint& b, const Joint& c) {
    const vec3 low = glm::min(glm::min(a.at, b.at), c.at), high = glm::max(glm::max(a.at, b.at), c.at);
    lobes_.push_back({{{a, b, c}}, {0.5f * (low + high), 0.5f * glm::distance(low, high) + kRoot + kMargin}});
  };
  for (const vec3& direction : directions) {
    const vec3 under = skinToward(skin, vec3(0, -5, 5) * shape_.size, direction);
    vec3 out = glm::normalize(glm::transpose(pose_.worldToHead) * slopeOf(skin, under));
    out = glm::normalize(out * vec3(1, 0.3f, 1));
    const vec3 tip = vec3(pose_.toWorld(under)) + out * (kTip - kPressed);
    vec3 root = tip + out * 22.f;
    root.y = kRootDepth;
    add({tip, kTip}, {0.5f * (tip + root) + out * 6.f, kMiddle}, {root, kRoot});
  }
  for (std::size_t n = 1; n < directions.size(); ++n) {
    const Joint &a = lobes_[0].joints[1], &b = lobes_[n].joints[1];
    add(a, {0.5f * (a.at + b.at), 0.8f * kMiddle}, b);
  }
}

// Membranes stand between the face and the first lobe, on its half of the face.
void PhantomModel::addMembranes(int count, std::uint32_t key) {
  const SkinFunction skin = [this](const vec3& p) { return skinOf(p); };
  std::vector<vec3> starts, towards;
  std::uint32_t index = 0;
  const auto between = [&](float low, float high) { return low + (high - low) * uniformAt(index++, key); };
  const float side = pose_.toHead(glm::dvec3(lobes_[0].joints[0].at)).x > 0 ? 1.f : -1.f;
  for (int n = 0; n < count; ++n) {
    const vec3 direction(side * between(-0.1f, 0.8f), between(-0.7f, 0.5f), 0.8f);
    const float along = between(0.2f, 1);
    const vec3 goal = glm::mix(lobes_[0].joints[0].at, lobes_[0].joints[1].at, along);
    const vec3 beside = n % 2 ? vec3(between(-0.1f, 0.1f), between(0.15f, 0.25f), 0) : vec3(0);
    for (int s = 0; s <= n % 2; ++s) {
      const vec3 at = skinToward(skin, vec3(0, -5, 5) * shape_.size, direction + float(s) * beside);
      starts.push_back(vec3(pose_.toWorld(at)));
      towards.push_back(glm::normalize(goal - starts.back() + vec3(0, -4, 0)));
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
    vec3& p = guide[n] *= shape_.size;
    for (int step = 0; step < 12; ++step) {
      const float d = skin(p) - 0.92f * radius;
      if (lies || d < 0) p -= slopeOf(skin, p) * (0.8f * d);
    }
    p = vec3(pose_.toWorld(p));
  }
  cord_ = makeCord(guide, radius);
}

}  // namespace sonoskin
