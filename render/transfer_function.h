#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/gl/texture.h"

namespace sonoskin {

// TransferFunction: what values look like. Between control points everything is linear.
//   opacity  0 to 1, of a layer as thick as 1/250 of the volume's diagonal
//   colour   linear Rec. 709
struct TransferFunction {
  struct Point {
    float value = 0;  // 0 to 1
    glm::vec3 colour{1};
    float opacity = 0;
    friend bool operator==(const Point&, const Point&) = default;
  };
  std::vector<Point> points;  // by rising value, at least one

  // at: rgb and opacity; the first point's below the first, the last point's above the last.
  glm::vec4 at(float value) const;
  // threshold: the largest value up to which everything is transparent; 0 where the opacity starts at once.
  float threshold() const;
  friend bool operator==(const TransferFunction&, const TransferFunction&) = default;
};

// amberTransfer: the warm look of fetal ultrasound: fluid is clear, faint echoes are dark red, strong ones
// ivory.
//   iso  0 to 1, the grey value at the border of the skin: half of the rise of the opacity
TransferFunction amberTransfer(float iso);

// greyTransfer: the same opacities without colour.
TransferFunction greyTransfer(float iso);

// makeTransferTexture: 1024 texels along x for the values 0 to 1, rgb and opacity as floats; to be read without
// interpolation.
//   layers  how many of the layers that the opacities mean a texel's opacity is of, >= 0
gl::Texture makeTransferTexture(const TransferFunction& transfer, float layers = 1);

}  // namespace sonoskin
