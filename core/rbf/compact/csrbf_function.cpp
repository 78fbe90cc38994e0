#include "core/rbf/compact/csrbf_function.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "core/rbf/compact/sample_block.h"

namespace sonoskin {
namespace {

constexpr float kSmallestCoverage = 0.01f;  // below it S is a ratio of two tiny numbers
constexpr int kNodesPerListCell = 16;
constexpr float kListCellsAlongBox = 64;  // never so many lists that they cost more than they save

// A block whose places are the nodes of a brick, relative to its corner.
SampleBlock brickNodes(float cell) {
  SampleBlock block;
  block.count = kBrickNodes;
  for (std::size_t n = 0; n < kBrickNodes; ++n) {
    const glm::vec3 place = cell * glm::vec3(nodePlace(int(n)));
    block.x[n] = place.x, block.y[n] = place.y, block.z[n] = place.z;
  }
  return block;
}

class CsrbfBricks {
 public:
  CsrbfBricks(const CsrbfModel& model, float cell, float listCell)
      : cell_(cell), index_(model.centres(), listCell, brickReach(cell)), nodes_(brickNodes(cell)) {
    spheres_.reserve(index_.entries().size());
    for (const std::uint32_t n : index_.entries())
      spheres_.emplace_back(index_.centres()[n].position, index_.centres()[n].support);
  }

  void sampleBrick(const glm::vec3& corner, float* value, float* coverage) const {
    SampleBlock block = nodes_;
    const float radius = 1.5f * std::sqrt(3.f) * cell_;  // of the nodes around their middle
    forEachCentre(corner + 1.5f * cell_, radius,
                  [&](const Centre& c) { addCentre(c, corner - c.position, block); });
    for (std::size_t n = 0; n < kBrickNodes; ++n) {
      coverage[n] = block.coverage[n];
      value[n] = block.coverage[n] >= kSmallestCoverage ? block.weighted[n] / block.coverage[n]
                                                        : std::numeric_limits<float>::quiet_NaN();
    }
  }

  void gradients(const glm::vec3& centre, std::span<const glm::vec3> positions, glm::vec3* result) const {
    for (std::size_t first = 0; first < positions.size(); first += GradientBlock::kSize) {
      const std::size_t used = std::min(positions.size() - first, GradientBlock::kSize);
      GradientBlock block;
      block.count = (used + 7) / 8 * 8;
      for (std::size_t i = 0; i < used; ++i) {
        const glm::vec3 p = positions[first + i] - centre;
        block.x[i] = p.x, block.y[i] = p.y, block.z[i] = p.z;
      }
      forEachCentre(centre, brickReach(cell_),
                    [&](const Centre& c) { addCentre(c, centre - c.position, block); });
      for (std::size_t i = 0; i < used; ++i) result[first + i] = {block.gx[i], block.gy[i], block.gz[i]};
    }
  }

 private:
  // The centres whose supports come within `radius` of a place.
  template <class F>
  void forEachCentre(const glm::vec3& place, float radius, F&& f) const {
    const std::span<const std::uint32_t> near = index_.near(place);
    const glm::vec4* sphere = spheres_.data() + (near.data() - index_.entries().data());
    thread_local std::vector<std::uint32_t> hits;
    hits.resize(std::max(hits.size(), near.size()));
    std::size_t count = 0;
    for (std::size_t i = 0; i < near.size();
         ++i) {  // every centre is written, only near ones are kept: no branch
      const glm::vec3 d = place - glm::vec3(sphere[i]);
      const float limit = sphere[i].w + radius;
      hits[count] = near[i];
      count += glm::dot(d, d) < limit * limit;
    }
    for (std::size_t i = 0; i < count; ++i) f(index_.centres()[hits[i]]);
  }

  float cell_;
  CentreIndex index_;
  std::vector<glm::vec4>
      spheres_;  // of the index' entries: two of three are too far away, told without their centres
  SampleBlock nodes_;
};

}  // namespace

ImplicitFunction csrbfFunction(const CsrbfModel& model, float cell) {
  float largest = 0;
  glm::vec3 low(std::numeric_limits<float>::infinity()), high = -low;
  for (const Centre& c : model.centres()) {
    largest = std::max(largest, c.support);
    low = glm::min(low, c.position);
    high = glm::max(high, c.position);
  }
  const glm::vec3 extent = high - low;
  const float listCell = std::max(float(kNodesPerListCell) * cell,
                                  std::max({extent.x, extent.y, extent.z}) / kListCellsAlongBox);
  const auto bricks = std::make_shared<const CsrbfBricks>(model, cell, listCell);
  ImplicitFunction function;
  function.cell = cell;
  function.reach = largest;
  function.sampleBrick = [bricks](const glm::vec3& corner, float* value, float* coverage) {
    bricks->sampleBrick(corner, value, coverage);
  };
  function.gradients = [bricks](const glm::vec3& centre, std::span<const glm::vec3> positions,
                                glm::vec3* result) { bricks->gradients(centre, positions, result); };
  return function;
}

}  // namespace sonoskin
