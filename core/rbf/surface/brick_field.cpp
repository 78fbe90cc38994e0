#include "core/rbf/surface/brick_field.h"

#include <array>
#include <bit>

#include "core/base/parallel_blocks.h"

namespace sonoskin {
namespace {

constexpr std::size_t kBricksPerTask = 64;

void activate(BrickField& field, const glm::ivec3& brick) {
  if (!field.map.contains(brick) || field.map.find(brick) != BrickMap::kNone) return;
  field.map.insert(brick, std::int32_t(field.bricks.size()));
  field.bricks.push_back(brick);
}

void sampleBrick(const ImplicitFunction& function, std::size_t brick, BrickField& field) {
  float* value = &field.value[brick * kBrickNodes];
  function.sampleBrick(field.corner(brick), value, &field.coverage[brick * kBrickNodes]);
  NodeSet inside = 0, defined = 0;
  for (std::size_t n = 0; n < kBrickNodes; ++n) {
    inside |= NodeSet(value[n] < 0) << n;
    defined |= NodeSet(value[n] == value[n]) << n;
  }
  field.inside[brick] = inside;
  field.defined[brick] = defined;
}

// The nodes from which an edge to the next node along an axis changes sign; `next` is the brick that follows, or none.
NodeSet cutEdges(const BrickField& field, std::size_t brick, std::int32_t next, int axis) {
  const NodeSet nextInside = next >= 0 ? field.inside[std::size_t(next)] : 0,
                nextDefined = next >= 0 ? field.defined[std::size_t(next)] : 0;
  const NodeSet changes = field.inside[brick] ^ shifted(field.inside[brick], nextInside, axis);
  return changes & field.defined[brick] & shifted(field.defined[brick], nextDefined, axis);
}

// Offsets: a set of bricks around one; bit (x + 1) + 3 (y + 1) + 9 (z + 1) is the brick at (x, y, z) from it.
using Offsets = std::uint32_t;
constexpr Offsets bitOf(const std::array<int, 3>& offset) {
  return 1u << (offset[0] + 1 + 3 * (offset[1] + 1) + 9 * (offset[2] + 1));
}

// EdgeCells: an edge along an axis that starts at one of these nodes has cells in the brick `here`, and if it ends in the
// next brick along the axis, in `next` too.
struct EdgeCells {
  NodeSet nodes = ~NodeSet(0);
  Offsets here = 0, next = 0;
};

// The cells around an edge reach one node to either side along the other two axes.
constexpr std::array<std::array<EdgeCells, 9>, 3> kEdgeCells = [] {
  std::array<std::array<EdgeCells, 9>, 3> result{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t k = 0; k < 9; ++k) {
      const std::array<std::size_t, 2> along{(axis + 1) % 3, (axis + 2) % 3};
      const std::array<int, 2> steps{int(k % 3) - 1, int(k / 3) - 1};
      EdgeCells& edge = result[axis][k];
      std::array<int, 3> offset{};
      for (std::size_t i = 0; i < 2; ++i) {
        offset[along[i]] = steps[i];
        if (steps[i] != 0) edge.nodes &= kLayer[along[i]][steps[i] < 0 ? 0 : kBrickEdge - 1];
      }
      edge.here = bitOf(offset);
      offset[axis] = 1;
      edge.next = bitOf(offset);
    }
  return result;
}();

// The bricks that the cells around cut edges along an axis reach.
Offsets neededBy(NodeSet cut, int axis) {
  const NodeSet ending = cut & kLayer[std::size_t(axis)][kBrickEdge - 1];
  Offsets needed = 0;
  for (const EdgeCells& edge : kEdgeCells[std::size_t(axis)]) {
    needed |= cut & edge.nodes ? edge.here : 0;
    needed |= ending & edge.nodes ? edge.next : 0;
  }
  return needed;
}

void activateAround(BrickField& field, const glm::ivec3& place, Offsets needed) {
  for (needed &= ~bitOf({0, 0, 0}); needed; needed &= needed - 1) {
    const int bit = std::countr_zero(needed);
    activate(field, place + glm::ivec3(bit % 3 - 1, bit / 3 % 3 - 1, bit / 9 - 1));
  }
}

// Growth: the bricks that the edges of a brick need: its own, and for each axis those of the brick before that end in it.
struct Growth {
  Offsets own = 0;
  std::array<Offsets, 3> before{};
};

Growth growthOf(const BrickField& field, std::size_t brick, std::size_t sampled) {
  const auto isSampled = [&](std::int32_t b) { return b >= 0 && std::size_t(b) < sampled; };
  const glm::ivec3 place = field.bricks[brick];
  Growth growth;
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 step(0);
    step[axis] = 1;
    const std::int32_t next = field.map.find(place + step), last = field.map.find(place - step);
    if (const NodeSet own = cutEdges(field, brick, isSampled(next) ? next : -1, axis))
      growth.own |= neededBy(own, axis);
    if (!isSampled(last)) continue;
    const NodeSet into = cutEdges(field, std::size_t(last), std::int32_t(brick), axis) &
                         kLayer[std::size_t(axis)][kBrickEdge - 1];
    if (into) growth.before[std::size_t(axis)] = neededBy(into, axis);
  }
  return growth;
}

void grow(BrickField& field, std::size_t brick, const Growth& growth) {
  const glm::ivec3 place = field.bricks[brick];
  activateAround(field, place, growth.own);
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 step(0);
    step[axis] = 1;
    if (const Offsets needed = growth.before[std::size_t(axis)]) activateAround(field, place - step, needed);
  }
}

void resizeSamples(BrickField& field) {
  field.value.resize(field.bricks.size() * kBrickNodes);
  field.coverage.resize(field.bricks.size() * kBrickNodes);
  field.inside.resize(field.bricks.size());
  field.defined.resize(field.bricks.size());
}

}  // namespace

BrickField sampleBricks(const ImplicitFunction& function, const std::vector<glm::vec3>& points, float margin,
                        const std::function<bool(const glm::vec3&)>& wanted, const Progress& progress) {
  const Box box = boundingBox(points);
  BrickField field;
  field.cell = function.cell;
  field.origin = box.min - margin;
  const float edge = float(kBrickEdge) * field.cell;
  field.map = BrickMap(glm::ivec3((box.max + margin - field.origin) / edge) + 1);
  glm::ivec3 last(-1);
  for (const glm::vec3& p : points)  // neighbours in the list are often neighbours in space
    if (const glm::ivec3 brick((p - field.origin) / edge); brick != last) activate(field, last = brick);

  const auto forEachNew = [&](std::size_t done, const Progress& part,
                              const std::function<void(std::size_t)>& f) {
    parallelItems(
        field.bricks.size() - done, kBricksPerTask, [&](std::size_t b) { f(done + b); }, part);
  };
  double fraction = 0;
  std::vector<Growth> growth;
  for (std::size_t done = 0; done < field.bricks.size();) {
    const std::size_t end = field.bricks.size();
    resizeSamples(field);
    growth.resize(end - done);
    const Progress part = progress.part(fraction, fraction + 0.5 * (1 - fraction));
    forEachNew(done, part, [&](std::size_t b) {
      if (wanted(field.centre(b))) sampleBrick(function, b, field);
    });
    forEachNew(done, part.cancelOnly(), [&](std::size_t b) { growth[b - done] = growthOf(field, b, end); });
    for (std::size_t b = done; b < end; ++b) grow(field, b, growth[b - done]);
    done = end;
    fraction += 0.5 * (1 - fraction);
  }
  return field;
}

}  // namespace sonoskin
