#include "core/rbf/global/global_function.h"

#include <algorithm>
#include <limits>
#include <mutex>
#include <optional>
#include <unordered_map>

#include "core/rbf/brick.h"
#include "core/rbf/global/global_block.h"

namespace sonoskin {
namespace {

constexpr double kBlockCells = 20;
constexpr float kCovered = 1e6f;  // above any limit, and finite for those who interpolate it

// GlobalBlocks: the blocks made so far. A block's edge is kBlockCells; it answers for bricks whose centre lies in it,
// and so reaches over its edge by what a brick reaches.
class GlobalBlocks {
 public:
  GlobalBlocks(std::shared_ptr<const GlobalRbf> model, float cell)
      : model_(std::move(model)),
        cell_(double(cell) / parts().frame.scale),
        halfEdge_((0.5 * kBlockCells + double(brickReach(1))) * cell_) {}

  void sampleBrick(const glm::vec3& corner, float* value) const {
    const glm::dvec3 unit = parts().frame.toUnit(glm::dvec3(corner));
    blockAt(unit + 2.0 * cell_).values(unit, cell_, std::span<float, kBrickNodes>(value, kBrickNodes));
  }

  void gradients(const glm::vec3& centre, std::span<const glm::vec3> positions, glm::vec3* result) const {
    Sites places;
    for (const glm::vec3& p : positions) places.push_back(parts().frame.toUnit(glm::dvec3(p)));
    const GlobalBlock& block = blockAt(parts().frame.toUnit(glm::dvec3(centre)));
    for (const glm::dvec3& g : block.gradients(places)) *result++ = glm::vec3(g / parts().frame.scale);
  }

 private:
  struct Entry {
    std::once_flag once;
    std::optional<GlobalBlock> block;
  };

  const GlobalRbf::Parts& parts() const { return model_->parts(); }

  // Whoever comes first makes the block; others wait for it.
  const GlobalBlock& blockAt(const glm::dvec3& place) const {
    const glm::ivec3 index(glm::floor(place / (kBlockCells * cell_)));
    Entry& entry = entryAt(index);
    std::call_once(entry.once, [&] {
      entry.block.emplace(parts(), (glm::dvec3(index) + 0.5) * (kBlockCells * cell_), halfEdge_);
    });
    return *entry.block;
  }
  Entry& entryAt(const glm::ivec3& index) const {
    constexpr std::int64_t kBits = 21, kOffset = 1 << 20;
    const std::int64_t key =
        ((index.x + kOffset) << (2 * kBits)) + ((index.y + kOffset) << kBits) + (index.z + kOffset);
    const std::scoped_lock lock(mutex_);
    return entries_[key];  // stays where it is when others are added
  }

  std::shared_ptr<const GlobalRbf> model_;
  double cell_, halfEdge_;  // in the unit frame
  mutable std::mutex mutex_;
  mutable std::unordered_map<std::int64_t, Entry> entries_;
};

}  // namespace

ImplicitFunction globalFunction(std::shared_ptr<const GlobalRbf> model, float cell) {
  const auto blocks = std::make_shared<const GlobalBlocks>(std::move(model), cell);
  ImplicitFunction function;
  function.cell = cell;
  function.reach = std::numeric_limits<float>::infinity();
  function.sampleBrick = [blocks](const glm::vec3& corner, float* value, float* coverage) {
    blocks->sampleBrick(corner, value);
    std::fill_n(coverage, kBrickNodes, kCovered);
  };
  function.gradients = [blocks](const glm::vec3& centre, std::span<const glm::vec3> positions,
                                glm::vec3* result) { blocks->gradients(centre, positions, result); };
  return function;
}

}  // namespace sonoskin
