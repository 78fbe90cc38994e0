#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/mesh/search/triangle_tree.h"
#include "core/phantom/body_part.h"
#include "core/phantom/phantom_options.h"
#include "core/phantom/scene_world.h"

namespace sonoskin::accuracy {

// Feature: a part of the face whose relief is compared: the skin around a place of the truth.
//   radius   mm
struct Feature {
  glm::vec3 centre{0};
  float radius = 0;
};

// FeaturePlaces: eyes within 0.25, nose within 0.3, mouth within 0.4 of the distance between the eyes, around the middle
// of each closed lid, the tip of the nose, and the middle between the corners of the mouth.
struct FeaturePlaces {
  std::array<Feature, 2> eyes;
  Feature nose, mouth;
};

// FacePose: where a face is and how it is turned. World mm.
//   up, front   unit, across each other: to the crown, and where the nose points
struct FacePose {
  FacePlaces places;
  glm::dvec3 up{0, 1, 0}, front{0, 0, 1};
};

// FaceAnatomy: what is known of a simulated baby beside its skin.
//   other   signed distance to tissue that is not the baby's, mm; empty where there is none
struct FaceAnatomy {
  FeaturePlaces features;
  std::function<double(const glm::dvec3& world)> other;
  FacePose pose{};
};

// phantomAnatomy: that of the phantom.
FaceAnatomy phantomAnatomy(const PhantomOptions& options);

// TruthPlace: one of many places spread evenly over the skin that the probe sees; each stands for the same area.
//   part   other where the truth has no labels
struct TruthPlace {
  glm::vec3 position{0}, normal{0};
  BodyPart part = BodyPart::other;
};

// FaceTruth: the skin of one simulated baby, ready to be compared with.
class FaceTruth {
 public:
  //   skin   with normals; visibility 1 where the probe sees it (without: everywhere); labels or none
  FaceTruth(Mesh skin, FaceAnatomy anatomy);
  FaceTruth(const FaceTruth&) = delete;
  FaceTruth& operator=(const FaceTruth&) = delete;

  // Foot: the place of the skin nearest to a point.
  //   distance   mm, negative inside the baby
  struct Foot {
    float distance = 0;
    glm::vec3 normal{0};
    bool isVisible = false;
  };
  // foot: where `query` would have to be. `guess` as TriangleTree::nearest has it.
  Foot foot(const glm::vec3& query, std::uint32_t& guess) const;
  // distanceUpTo: mm to the nearest skin, seen or not; `limit` where it is farther.
  float distanceUpTo(const glm::vec3& query, float limit) const;

  const Mesh& skin() const { return skin_; }
  const FeaturePlaces& features() const { return anatomy_.features; }
  const FacePose& pose() const { return anatomy_.pose; }
  // isOtherTissue: whether tissue that is not the baby's is nearer than 2 mm.
  bool isOtherTissue(const glm::vec3& query) const;
  // visible: places 0.5 mm apart, of what the probe sees.
  const std::vector<TruthPlace>& visible() const { return visible_; }

 private:
  void spreadVisible();

  Mesh skin_;
  FaceAnatomy anatomy_;
  TriangleTree tree_;
  std::vector<TruthPlace> visible_;
};

}  // namespace sonoskin::accuracy
