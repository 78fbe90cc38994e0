#include "core/surface/thinning.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"
#include "core/volume/sample.h"

namespace sonoskin {
namespace {

constexpr float kLeast = 0.02f;     // share of a surface voxel's u below which a neighbour's is noise
constexpr float kFarthest = 0.75f;  // of a step; where the ridge runs obliquely through long voxels
constexpr int kBlock = 32;          // voxels of a row that are looked at together

// Where the ridge lies between the neighbours at -1 and 1, from the inverses of u there. Across a surface u is a
// Lorentzian, gamma h uind / (alpha a + gamma h) with a squared distance a, so 1/u is a parabola and its lowest point
// exact; a parabola through u itself would be off by up to 0.06.
//   excess   what interpolation between voxels adds to both neighbours, as a share of the parabola there
float ridgeOffset(float before, float centre, float after, float excess) {
  const float curvature = before - 2 * centre + after;
  if (curvature < 1e-6f) return 0;
  return std::clamp(0.5f * (1 + excess) * (before - after) / curvature, -kFarthest, kFarthest);
}

// Linear interpolation of a squared distance s² adds x (1 - x) h² / 2 times its second derivative, x: the fraction of a
// voxel, h: spacing. Of the squared distance from a plane across `step` (voxels), as a share of that at its end:
float interpolationExcess(const glm::vec3& step, const glm::vec3& spacing) {
  const glm::vec3 x = glm::abs(step), h2 = spacing * spacing;
  const float length2 = glm::dot(x * x, h2);
  return glm::dot(x * x * x * (1.0f - x), h2 * h2) / (length2 * length2);
}

// Bilinear in the plane of `corner`, at a, b in [-1, 1] steps of strideA, strideB from it.
template <class Value>
float sampleInPlane(const float* corner, std::ptrdiff_t strideA, std::ptrdiff_t strideB, float a, float b,
                    const Value& value) {
  if (a < 0) strideA = -strideA, a = -a;
  if (b < 0) strideB = -strideB, b = -b;
  const auto alongA = [&](const float* v) { return value(v[0]) + a * (value(v[strideA]) - value(v[0])); };
  const float near = alongA(corner);
  return near + b * (alongA(corner + strideB) - near);
}

// BorderTest: whether positions lie `margin` or more within a view. The depth changes by at most the way that one goes:
// where it was large, it need not be asked again nearby. One for each slice of voxels.
class BorderTest {
 public:
  BorderTest(const FieldOfView& view, float margin, int rowLength)
      : view_(view), margin_(margin), safe_(std::size_t(rowLength) / kBlock + 1) {}

  bool passes(int i, const glm::vec3& position) {
    Ball& ball = safe_[std::size_t(i) / kBlock];
    const glm::vec3 d = position - ball.centre;
    if (glm::dot(d, d) < ball.squaredRadius) return true;
    const float radius = view_.depth(position) - margin_;
    if (radius > 0 && !view_.inside) ball = {position, radius * radius};  // the depth in a mask is rounded
    return radius >= 0;
  }

 private:
  struct Ball {
    glm::vec3 centre{0};
    float squaredRadius = 0;
  };
  const FieldOfView& view_;
  float margin_;
  std::vector<Ball> safe_;  // one for each block of a row
};

// Thinner: tests single voxels; holds what all of them need. Positions are voxel index .* spacing, mm.
class Thinner {
 public:
  Thinner(const Volume<float>& u, const Volume<float>& lowPassed, const ScanFrame& frame,
          const SurfaceOptions& options)
      : u_(u),
        lowPassed_(lowPassed),
        beams_(frame.beam, u.geometry),
        axisScale_(u.geometry.axisScale()),
        spacing_(u.geometry.spacing),
        stride_{1, u.geometry.dims.x, std::ptrdiff_t(u.geometry.index(0, 0, 1))},
        threshold_(float(options.threshold)),
        facing_(float(leastFacing(options))) {}

  // thinRow: the surface voxels of one inner row. Most of a volume is far below the threshold: a pass that the
  // compiler vectorises skips it.
  void thinRow(int j, int k, BorderTest& border, std::vector<SurfaceVoxel>& found) const {
    const int end = u_.geometry.dims.x - 1;
    const float* row = &u_.at(0, j, k);
    for (int first = 1; first < end; first += kBlock) {
      const int last = std::min(first + kBlock, end);
      float most = 0;
#pragma omp simd reduction(max : most)
      for (int i = first; i < last; ++i) most = std::max(most, row[i]);
      if (most < threshold_) continue;
      for (int i = first; i < last; ++i)
        if (row[i] >= threshold_) testVoxel({i, j, k}, border, found);
    }
  }

 private:
  // The tests in the order of what they cost for what they drop.
  void testVoxel(const glm::ivec3& voxel, BorderTest& border, std::vector<SurfaceVoxel>& found) const {
    const std::size_t index = u_.geometry.index(voxel.x, voxel.y, voxel.z);
    const glm::vec3 gradient = gradientAt(lowPassed_, axisScale_, index);
    glm::vec3 step = gradient * axisScale_;  // a step in mm along the gradient, in voxels
    const float longest = std::max({std::abs(step.x), std::abs(step.y), std::abs(step.z)});
    if (longest < 1e-12f) return;
    const glm::vec3 position = glm::vec3(voxel) * spacing_;
    const float facing = facingOf(position, gradient);
    if (facing <= facing_) return;
    step /= longest;
    const auto asItIs = [](float u) { return u; };
    const float centre = u_.data[index], after = neighbour(index, step, asItIs);
    if (centre < after) return;
    const float before = neighbour(index, -step, asItIs);
    if (centre <= before) return;
    if (!border.passes(voxel.x, position)) return;
    // Between voxels too 1/u is nearly a parabola, and closer to what is interpolated than u.
    const auto inverse = [&](float u) { return 1 / std::max(u, kLeast * centre); };
    const float offset = ridgeOffset(neighbour(index, -step, inverse), 1 / centre,
                                     neighbour(index, step, inverse), interpolationExcess(step, spacing_));
    found.push_back({voxel, glm::vec3(voxel) + offset * step, centre, facing});
  }

  float facingOf(const glm::vec3& position, const glm::vec3& gradient) const {
    const glm::vec3 beam = beams_.towards(position);
    return glm::dot(gradient, beam) / std::sqrt(glm::dot(gradient, gradient) * glm::dot(beam, beam));
  }

  // The value one step away: a step is one voxel along its longest axis, so that it ends in a plane of voxels.
  template <class Value>
  float neighbour(std::size_t index, const glm::vec3& step, const Value& value) const {
    const glm::vec3 size = glm::abs(step);
    const int main = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int a = (main + 1) % 3, b = (main + 2) % 3;
    const float* corner = u_.data.data() + index;
    corner += step[main] > 0 ? stride_[std::size_t(main)] : -stride_[std::size_t(main)];
    return sampleInPlane(corner, stride_[std::size_t(a)], stride_[std::size_t(b)], step[a], step[b], value);
  }

  const Volume<float>&u_, &lowPassed_;
  LocalBeams beams_;
  glm::vec3 axisScale_, spacing_;
  std::array<std::ptrdiff_t, 3> stride_;
  float threshold_, facing_;
};

}  // namespace

double leastFacing(const SurfaceOptions& options) {
  constexpr double kSidesFacing = -0.7;  // beyond it lies the end of an echo, not a side
  return options.sides > 0 ? std::min(options.facing, kSidesFacing) : options.facing;
}

std::vector<SurfaceVoxel> thin(const Volume<float>& classified, const Volume<float>& lowPassed,
                               const ScanFrame& frame, const SurfaceOptions& options,
                               const Progress& progress) {
  const glm::ivec3 dims = classified.geometry.dims;
  const Thinner thinner(classified, lowPassed, frame, options);
  const float margin = float(options.borderMargin * classified.geometry.minSpacing());
  std::vector<std::vector<SurfaceVoxel>> perSlice(std::size_t(std::max(0, dims.z - 2)));
  parallelFor(
      dims.z - 2,
      [&](std::ptrdiff_t inner) {
        BorderTest border(frame.view, margin, dims.x);
        for (int j = 1; j < dims.y - 1; ++j)
          thinner.thinRow(j, int(inner) + 1, border, perSlice[std::size_t(inner)]);
      },
      progress);
  std::vector<SurfaceVoxel> all;
  std::size_t count = 0;
  for (const auto& slice : perSlice) count += slice.size();
  all.reserve(count);
  for (const auto& slice : perSlice) all.insert(all.end(), slice.begin(), slice.end());
  return all;
}

}  // namespace sonoskin
