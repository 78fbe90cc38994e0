#include "core/rbf/brick_field.h"

#include <bit>

#include "core/base/parallel.h"

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
Offsets bitOf(const glm::ivec3& offset) {
  return 1u << (offset.x + 1 + 3 * (offset.y + 1) + 9 * (offset.z + 1));
}

// The bricks that cells around cut edges reach: one node to either side along the other two axes, and for edges that
// end in the next brick along the axis there too.
Offsets neededBy(NodeSet cut, int axis) {
  const auto side = [](int along, int step) {
    return step == 0 ? ~NodeSet(0) : kLayer[std::size_t(along)][step < 0 ? 0 : kBrickEdge - 1];
  };
  const int b = (axis + 1) % 3, c = (axis + 2) % 3;
  Offsets needed = 0;
  for (int stepB = -1; stepB <= 1; ++stepB)
    for (int stepC = -1; stepC <= 1; ++stepC) {
      const NodeSet reaching = cut & side(b, stepB) & side(c, stepC);
      if (reaching == 0) continue;
      glm::ivec3 offset(0);
      offset[b] = stepB, offset[c] = stepC;
      needed |= bitOf(offset);
      if ((reaching & kLayer[std::size_t(axis)][kBrickEdge - 1]) == 0) continue;
      offset[axis] = 1;
      needed |= bitOf(offset);
    }
  return needed;
}

void activateAround(BrickField& field, const glm::ivec3& place, Offsets needed) {
  for (needed &= ~bitOf(glm::ivec3(0)); needed; needed &= needed - 1) {
    const int bit = std::countr_zero(needed);
    activate(field, place + glm::ivec3(bit % 3 - 1, bit / 3 % 3 - 1, bit / 9 - 1));
  }
}

// Adds the bricks that a brick's own edges, and those that end in it, need.
void grow(BrickField& field, std::size_t brick, std::size_t sampled) {
  const auto isSampled = [&](std::int32_t b) { return b >= 0 && std::size_t(b) < sampled; };
  const glm::ivec3 place = field.bricks[brick];
  Offsets needed = 0;
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 step(0);
    step[axis] = 1;
    const std::int32_t next = field.map.find(place + step), last = field.map.find(place - step);
    if (const NodeSet own = cutEdges(field, brick, isSampled(next) ? next : -1, axis))
      needed |= neededBy(own, axis);
    if (!isSampled(last)) continue;
    const NodeSet into = cutEdges(field, std::size_t(last), std::int32_t(brick), axis) &
                         kLayer[std::size_t(axis)][kBrickEdge - 1];
    if (into) activateAround(field, place - step, neededBy(into, axis));
  }
  activateAround(field, place, needed);
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
  for (const glm::vec3& p : points) activate(field, glm::ivec3((p - field.origin) / edge));

  double fraction = 0;
  for (std::size_t done = 0; done < field.bricks.size();) {
    const std::size_t end = field.bricks.size();
    resizeSamples(field);
    const Progress part = progress.part(fraction, fraction + 0.5 * (1 - fraction));
    parallelFor(
        std::ptrdiff_t((end - done + kBricksPerTask - 1) / kBricksPerTask),
        [&](std::ptrdiff_t task) {
          const std::size_t first = done + std::size_t(task) * kBricksPerTask;
          for (std::size_t b = first; b < std::min(first + kBricksPerTask, end); ++b)
            if (wanted(field.centre(b))) sampleBrick(function, b, field);
        },
        part);
    for (; done < end; ++done) grow(field, done, end);
    fraction += 0.5 * (1 - fraction);
  }
  return field;
}

}  // namespace sonoskin
