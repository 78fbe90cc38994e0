#include "app/views/parts_scene.h"

namespace sonoskin::ui {

const std::shared_ptr<const Mesh>& PartsScene::meshFor(const Results& results) {
  if (parts_ != results.parts || verdicts_ != results.verdicts) {
    parts_ = results.parts;
    verdicts_ = results.verdicts;
    mesh_ = std::make_shared<const Mesh>(
        makePartsMesh(parts_->mesh, parts_->parts.ofTriangle, tintsOf(*verdicts_)));
  }
  return mesh_;
}

std::vector<PartTint> tintsOf(const std::vector<PartVerdict>& verdicts) {
  std::vector<PartTint> tints;
  for (std::size_t p = 0; p < verdicts.size(); ++p) {
    tints.push_back({verdicts[p].isFace ? 0 : 1 + int(p) % (kPartColours - 1), !verdicts[p].kept});
  }
  return tints;
}

}  // namespace sonoskin::ui
