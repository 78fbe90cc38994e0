#include "core/rbf/brick_field.h"

#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/rbf/sample_block.h"

namespace sonoskin {
namespace {

constexpr float kSmallestCoverage = 0.01f;  // below it S is a ratio of two tiny numbers
constexpr float kSeedReach = 0.6f;          // cells around a point
constexpr float kNearSurface = 1.2f;        // cells: a neighbouring brick may hold the surface
constexpr std::size_t kBricksPerTask = 64;

void activate(BrickField& field, const glm::ivec3& brick) {
  if (!field.map.contains(brick) || field.map.find(brick) != BrickMap::kNone) return;
  field.map.insert(brick, std::int32_t(field.bricks.size()));
  field.bricks.push_back(brick);
}

void activateAround(BrickField& field, const glm::vec3& point) {
  const float edge = float(kBrickEdge) * field.cell, reach = kSeedReach * field.cell;
  const glm::ivec3 low(glm::floor((point - reach - field.origin) / edge));
  const glm::ivec3 high(glm::floor((point + reach - field.origin) / edge));
  for (int k = low.z; k <= high.z; ++k)
    for (int j = low.y; j <= high.y; ++j)
      for (int i = low.x; i <= high.x; ++i) activate(field, {i, j, k});
}

// A block whose places are the nodes of a brick, relative to its corner.
SampleBlock brickNodes(float cell) {
  SampleBlock block;
  block.count = kBrickNodes;
  for (std::size_t n = 0; n < kBrickNodes; ++n) {
    block.x[n] = float(n % 4) * cell;
    block.y[n] = float(n / 4 % 4) * cell;
    block.z[n] = float(n / 16) * cell;
  }
  return block;
}

void sampleBrick(const CentreIndex& index, std::size_t brick, const SampleBlock& nodes, BrickField& field) {
  SampleBlock block = nodes;
  const glm::vec3 corner = field.corner(brick);
  const glm::vec3 middle = corner + 1.5f * field.cell;  // of the nodes
  const float radius = 1.5f * std::sqrt(3.f) * field.cell;
  for (const std::uint32_t n : index.near(field.centre(brick))) {
    const Centre& c = index.centres()[n];
    const glm::vec3 d = middle - c.position;
    const float limit = c.support + radius;
    if (glm::dot(d, d) < limit * limit) addCentre(c, corner - c.position, block);
  }
  for (std::size_t n = 0; n < kBrickNodes; ++n) {
    const bool isDefined = block.coverage[n] >= kSmallestCoverage;
    field.coverage[brick * kBrickNodes + n] = block.coverage[n];
    field.value[brick * kBrickNodes + n] =
        isDefined ? block.weighted[n] / block.coverage[n] : std::numeric_limits<float>::quiet_NaN();
  }
}

// Whether the surface may go on across one face of a brick. side: 0 low, 1 high.
bool mayCrossFace(const float* value, int axis, int side, float cell) {
  const std::size_t stride[3] = {1, 4, 16};
  const std::size_t across = stride[axis], u = stride[(axis + 1) % 3], v = stride[(axis + 2) % 3];
  bool negative = false, positive = false, near = false;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = 0; b < 4; ++b) {
      const float s = value[(side ? 3 * across : 0) + a * u + b * v];  // NaN fails every comparison
      negative |= s < 0;
      positive |= s >= 0;
      near |= std::abs(s) < kNearSurface * cell;
    }
  return near || (negative && positive);
}

void grow(BrickField& field, std::size_t brick) {
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      glm::ivec3 next = field.bricks[brick];
      next[axis] += side ? 1 : -1;
      if (mayCrossFace(&field.value[brick * kBrickNodes], axis, side, field.cell)) activate(field, next);
    }
}

}  // namespace

BrickField sampleBricks(const CentreIndex& index, const std::vector<glm::vec3>& points, float cell,
                        float margin, const Progress& progress) {
  const Box box = boundingBox(points);
  BrickField field;
  field.cell = cell;
  field.origin = box.min - margin;
  field.map = BrickMap(glm::ivec3((box.max + margin - field.origin) / (float(kBrickEdge) * cell)) + 1);
  for (const glm::vec3& p : points) activateAround(field, p);

  const SampleBlock nodes = brickNodes(cell);
  double fraction = 0;
  for (std::size_t done = 0; done < field.bricks.size();) {
    const std::size_t end = field.bricks.size();
    field.value.resize(end * kBrickNodes);
    field.coverage.resize(end * kBrickNodes);
    const Progress part = progress.part(fraction, fraction + 0.5 * (1 - fraction));
    parallelFor(
        std::ptrdiff_t((end - done + kBricksPerTask - 1) / kBricksPerTask),
        [&](std::ptrdiff_t task) {
          const std::size_t first = done + std::size_t(task) * kBricksPerTask;
          for (std::size_t b = first; b < std::min(first + kBricksPerTask, end); ++b)
            sampleBrick(index, b, nodes, field);
        },
        part);
    for (; done < end; ++done) grow(field, done);
    fraction += 0.5 * (1 - fraction);
  }
  return field;
}

}  // namespace sonoskin
