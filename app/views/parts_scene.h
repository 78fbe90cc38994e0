#pragma once

#include <memory>

#include "core/pipeline/pipeline.h"
#include "render/parts_mesh.h"

namespace sonoskin::ui {

// PartsScene: the surface in the colours of its parts, made anew where parts or verdicts have changed.
class PartsScene {
 public:
  // meshFor: needs results with parts.
  const std::shared_ptr<const Mesh>& meshFor(const Results& results);

 private:
  std::shared_ptr<const PartedSurface> parts_;
  std::shared_ptr<const std::vector<PartVerdict>> verdicts_;
  std::shared_ptr<const Mesh> mesh_;
};

// tintsOf: the face is the colour of skin, others have one each in turn; those that are off are dim.
std::vector<PartTint> tintsOf(const std::vector<PartVerdict>& verdicts);

}  // namespace sonoskin::ui
