#include "core/volume/mask_depth.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/parallel_blocks.h"

namespace sonoskin {
namespace {

constexpr float kSteps = 8;  // per smallest spacing

// Envelope: the lowest of the parabolas f[q] + (p - q)^2 at every p of a line.
class Envelope {
 public:
  explicit Envelope(std::size_t longest) : at_(longest + 2), from_(longest + 3), height_(longest + 2) {}

  // lower: replaces values (squared distances) by the envelope; `step` is the distance between neighbours. Beyond
  // both ends the value is 0.
  void lower(std::vector<float>& values, float step) {
    count_ = 0;
    add(-1, 0, step);
    for (std::size_t q = 0; q < values.size(); ++q) add(int(q), values[q], step);
    add(int(values.size()), 0, step);
    std::size_t piece = 0;
    for (std::size_t p = 0; p < values.size(); ++p) {
      while (piece + 1 < count_ && from_[piece + 1] < float(p)) ++piece;
      const float away = step * float(int(p) - at_[piece]);
      values[p] = height_[piece] + away * away;
    }
  }

 private:
  void add(int q, float height, float step) {
    float crossing = -1e30f;
    while (count_ > 0) {
      const int last = at_[count_ - 1];
      crossing = 0.5f * ((height - height_[count_ - 1]) / (step * step * float(q - last)) + float(q + last));
      if (crossing > from_[count_ - 1]) break;
      --count_;
      crossing = -1e30f;
    }
    at_[count_] = q, height_[count_] = height, from_[count_] = crossing;
    ++count_;
  }

  std::vector<int> at_;
  std::vector<float> from_, height_;
  std::size_t count_ = 0;
};

// Lines of a volume along one axis: how many, the values of each, how far those lie apart in memory and in space.
struct Lines {
  std::size_t count, length, stride;
  float step;
};

// Lowers every line; line n begins at start(n).
template <class Start>
void lowerLines(std::vector<float>& squared, const Lines& lines, const Start& start,
                const Progress& progress) {
  constexpr std::size_t kLinesPerTask = 64;
  parallelBlocks(
      lines.count, kLinesPerTask,
      [&](std::size_t firstLine, std::size_t endLine) {
        Envelope envelope(lines.length);
        std::vector<float> line(lines.length);
        for (std::size_t n = firstLine; n < endLine; ++n) {
          float* first = squared.data() + start(n);
          for (std::size_t p = 0; p < lines.length; ++p) line[p] = first[p * lines.stride];
          envelope.lower(line, lines.step);
          for (std::size_t p = 0; p < lines.length; ++p) first[p * lines.stride] = line[p];
        }
      },
      progress);
}

}  // namespace

Volume<std::uint8_t> maskDepth(const Volume<std::uint8_t>& mask, const Progress& progress) {
  const Geometry& g = mask.geometry;
  const auto nx = std::size_t(g.dims.x), ny = std::size_t(g.dims.y), nz = std::size_t(g.dims.z);
  const glm::vec3 step(g.spacing / g.minSpacing());
  std::vector<float> squared(mask.data.size());
  for (std::size_t v = 0; v < squared.size(); ++v) squared[v] = mask.data[v] ? 1e12f : 0.0f;
  lowerLines(
      squared, {ny * nz, nx, 1, step.x}, [&](std::size_t n) { return n * nx; }, progress.part(0, 0.3));
  lowerLines(
      squared, {nx * nz, ny, nx, step.y}, [&](std::size_t n) { return n / nx * nx * ny + n % nx; },
      progress.part(0.3, 0.6));
  lowerLines(
      squared, {nx * ny, nz, nx * ny, step.z}, [](std::size_t n) { return n; }, progress.part(0.6, 0.9));
  Volume<std::uint8_t> depth(g);
  for (std::size_t v = 0; v < squared.size(); ++v)  // the border is half a voxel before the voxel outside
    if (mask.data[v])
      depth.data[v] = std::uint8_t(std::clamp(kSteps * (std::sqrt(squared[v]) - 0.5f), 1.0f, 255.0f));
  progress.update(1);
  return depth;
}

float depthInMask(const Volume<std::uint8_t>& depth, const glm::vec3& position) {
  const Geometry& g = depth.geometry;
  const glm::ivec3 voxel(glm::round(position / glm::vec3(g.spacing)));
  if (glm::any(glm::lessThan(voxel, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(voxel, g.dims)))
    return -1;
  const std::uint8_t steps = depth.at(voxel.x, voxel.y, voxel.z);
  if (steps == 0) return -float(g.minSpacing());
  return steps == 255 ? 1e30f : float(steps) / kSteps * float(g.minSpacing());
}

}  // namespace sonoskin
