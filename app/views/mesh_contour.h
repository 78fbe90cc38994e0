#pragma once

#include <memory>
#include <vector>

#include "app/views/pane.h"
#include "app/workspace/objects_seen.h"
#include "core/mesh/plane_section.h"
#include "render/slice_frame.h"

namespace sonoskin::ui {

// MeshContour: where a surface meets a slice; kept until either is another one.
struct MeshContour {
  ObjectsSeen<1> from;
  glm::dvec3 point{0}, normal{0};
  std::vector<Segment> segments;

  // update: that of a surface, which may be null, and the slice that a frame shows.
  void update(const std::shared_ptr<const Mesh>& mesh, const SliceFrame& frame);
};

// drawContour: its lines over the slice's picture.
void drawContour(const MeshContour& contour, const SliceFrame& frame, const PaneInput& pane);

}  // namespace sonoskin::ui
