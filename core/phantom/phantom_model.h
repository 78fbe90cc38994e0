#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/phantom/body_part.h"
#include "core/phantom/cord.h"
#include "core/phantom/fetal_arm.h"
#include "core/phantom/head_pose.h"
#include "core/phantom/head_shape.h"
#include "core/phantom/membranes.h"
#include "core/phantom/phantom_options.h"
#include "core/phantom/scene_world.h"

namespace sonoskin {

struct ScenePlan;

// PhantomModel: the anatomy that options ask for (scene, shape and seed), in the world of the simulated scan:
// signed distances in mm, negative inside.
//   cost     the value 20 ms at most; a distance 0.5 us near the face, more with hands or cord
//   threads  const functions may be called from any
class PhantomModel {
 public:
  explicit PhantomModel(const PhantomOptions& options);

  // skin: to the baby's skin; |gradient| is 1 at the skin but for creases, where it is shorter; Lipschitz
  // constant below 1.25 but for the depths of the face, more than 4 mm below the skin.
  double skin(const glm::dvec3& world) const;
  // bone: to the baby's bones.
  double bone(const glm::dvec3& world) const;
  // wall: to the uterine wall and the placenta, negative inside the mother's tissue.
  double wall(const glm::dvec3& world) const;
  // strands: to membranes and cord, which lie in the fluid; large where the scene has none. hasStrands: whether
  // it has any.
  double strands(const glm::dvec3& world) const;
  bool hasStrands() const { return !membranes_.empty() || !cord_.axis.empty(); }
  // other: to everything that is not the baby's skin: the least of wall and strands.
  double other(const glm::dvec3& world) const;

  // isCrowded: whether other tissue may lie on the skin that is to be seen. In the first phantom it does so at
  // the border of the field of view only, which its truth leaves out of account.
  bool isCrowded() const { return hasStrands() || !lobes_.empty() || !isFirstArm_; }

  // part: of the baby, to which a place on or near the skin belongs; never `other`.
  BodyPart part(const glm::dvec3& world) const;

  // facePlaces: of this head in its pose; on the skin of the face, also where a hand lies on it.
  FacePlaces facePlaces() const;
  const HeadPose& head() const { return pose_; }
  const HeadShape& headShape() const { return shape_; }

 private:
  float headAndTrunk(const glm::vec3& head) const;
  float skinOf(const glm::vec3& head) const;
  glm::vec3 toTrunk(const glm::vec3& head) const { return headToTrunk_ * head + trunkShift_; }
  void layTrunk(const ScenePlan& plan);
  bool onFace(const glm::vec3& head) const;
  void measureFace();
  void layArms(const ScenePlan& plan);
  void attachLobes(const std::vector<glm::vec3>& directions);
  void addMembranes(int count, std::uint32_t key);
  void layCord(int side, std::uint32_t key);

  // Lobe: placenta or wall that comes up to the skin; world.
  struct Lobe {
    std::array<sdf::Joint, 3> joints;
    sdf::Reach reach;
  };

  HeadPose pose_;
  HeadShape shape_;
  glm::vec3 eyes_{0}, faceScale_{1};  // between the eyes; sizes of the face beside the first one's
  float wallBack_ = 0;
  glm::mat3 headToTrunk_{1};
  glm::vec3 trunkShift_{0};
  bool rightArmHangs_ = true, isFirstArm_ = false;
  std::vector<Arm> arms_;            // head's frame
  std::vector<Lobe> lobes_;          // world
  std::vector<Membrane> membranes_;  // world
  Cord cord_;                        // world
};

}  // namespace sonoskin
