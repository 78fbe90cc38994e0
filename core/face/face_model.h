#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "core/phantom/fetal_head.h"

namespace sonoskin {

// FaceModes: how far a face goes along each mode of shape; 0 is the mean face, 1 one standard deviation.
inline constexpr int kFaceModes = 14;
using FaceModes = std::array<float, kFaceModes>;

// FacePoint: a place on the skin of the mean face, in the head's frame (fetal_head.h), mm.
//   normal   unit, outward
//   weight   area that it stands for, times what that part tells of a face; the sum over a model is 1
//   along    mm that it moves along its normal for one standard deviation of each mode
struct FacePoint {
  glm::vec3 place, normal;
  float weight = 0;
  std::array<float, kFaceModes> along{};
};

// FaceNeighbour: a point of the inner face and its share in the mean around another.
struct FaceNeighbour {
  std::uint32_t point;
  float share;
};

// FaceModel: the mean face of the family of heads (head_shape.h) and the main ways in which they differ.
//   points   of every prefix are spread evenly, so that the first hundred do for a rough look
//   inner    the points of eyes, nose and mouth, with those around each for its relief
//   moves    how far landmarks move for one standard deviation of each mode
struct FaceModel {
  struct Inner {
    std::uint32_t point;
    std::vector<FaceNeighbour> around;
  };
  std::vector<FacePoint> points;
  std::vector<Inner> inner;
  HeadPlaces places;
  std::array<HeadPlaces, kFaceModes> moves;
};

// faceModel: made when it is first asked for.
//   method   The skin's way along its normal for each trait of the shape, by differences; what a change of place,
//            turn or size does as well is taken out, for a fit has those already; the modes are the principal
//            components of the rest, for traits that vary as the family's do.  [Cootes 1995]
//   cost     25 ms, once
//   threads  any
const FaceModel& faceModel();

}  // namespace sonoskin
