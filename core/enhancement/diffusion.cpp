#include "core/enhancement/diffusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/parallel_blocks.h"
#include "core/volume/sample.h"

namespace sonoskin {
namespace {

constexpr double kSamples = 230'000;  // about so many voxels tell the typical gradient, evenly spread
constexpr float kOfLongestStep = 0.9f;
constexpr std::size_t kSlab = 8;  // slices that one task computes

// The median gradient, per smallest spacing, of inner voxels that are not 0 (outside a sector all are).
float typicalGradient(const Volume<float>& volume) {
  const Geometry& g = volume.geometry;
  const glm::vec3 axisScale = g.axisScale();
  const int stride = std::max(1, int(std::cbrt(double(g.voxels()) / kSamples)));
  std::vector<float> gradients;
  for (int k = 1; k < g.dims.z - 1; k += stride)
    for (int j = 1; j < g.dims.y - 1; j += stride)
      for (int i = 1; i < g.dims.x - 1; i += stride) {
        const std::size_t index = g.index(i, j, k);
        if (volume.data[index] > 0) gradients.push_back(glm::length(gradientAt(volume, axisScale, index)));
      }
  if (gradients.empty()) return 0;
  const auto middle = gradients.begin() + std::ptrdiff_t(gradients.size() / 2);
  std::nth_element(gradients.begin(), middle, gradients.end());
  return *middle;
}

// Row: a row of voxels and its neighbours along j and k; beyond the volume's border lies the row itself.
struct Row {
  const float *at, *before, *after, *below, *above;
};

// Step: one explicit step of the diffusion, from one volume into another.
class Step {
 public:
  Step(const Volume<float>& from, float edgeGradient, Volume<float>& to)
      : from_(from),
        to_(to),
        dims_(from.geometry.dims),
        scale_(0.5f * from.geometry.axisScale()),
        squaredEdge_(edgeGradient * edgeGradient) {
    const glm::vec3 weight = from.geometry.axisScale() * from.geometry.axisScale();
    // Both neighbours' conductances are added where their mean is meant.
    weight_ = weight * (0.5f * kOfLongestStep / (2 * (weight.x + weight.y + weight.z)));
  }

  // run: the slices [begin, end) of the result.
  void run(int begin, int end) const {
    const std::size_t slice = from_.geometry.index(0, 0, 1);
    std::array<std::vector<float>, 3> ring;  // the conductances of slice k are in ring[k % 3]
    for (auto& plane : ring) plane.resize(slice);
    const auto plane = [&](int k) { return ring[std::size_t(std::clamp(k, 0, dims_.z - 1)) % 3].data(); };
    const auto fill = [&](int k) {
      if (k >= 0 && k < dims_.z) conductances(k, plane(k));
    };
    fill(begin - 1);
    fill(begin);
    for (int k = begin; k < end; ++k) {
      fill(k + 1);
      for (int j = 0; j < dims_.y; ++j) {
        const auto shift = [&](int row) { return std::ptrdiff_t(rowWithin(row)) * dims_.x; };
        flow(rowOf(j, k),
             {plane(k) + shift(j), plane(k) + shift(j - 1), plane(k) + shift(j + 1), plane(k - 1) + shift(j),
              plane(k + 1) + shift(j)},
             &to_.at(0, j, k));
      }
    }
  }

 private:
  int rowWithin(int j) const { return std::clamp(j, 0, dims_.y - 1); }

  Row rowOf(int j, int k) const {
    const auto at = [&](int row, int slice) {
      return &from_.at(0, rowWithin(row), std::clamp(slice, 0, dims_.z - 1));
    };
    return {at(j, k), at(j - 1, k), at(j + 1, k), at(j, k - 1), at(j, k + 1)};
  }

  // conductances: c of one slice. A volume without gradients does not change: any c serves.
  void conductances(int k, float* out) const {
    for (int j = 0; j < dims_.y; ++j, out += dims_.x) {
      const Row u = rowOf(j, k);
      const auto one = [&](int i, int left, int right) {
        const float x = scale_.x * (u.at[right] - u.at[left]), y = scale_.y * (u.after[i] - u.before[i]),
                    z = scale_.z * (u.above[i] - u.below[i]);
        out[i] = squaredEdge_ / (squaredEdge_ + x * x + y * y + z * z + 1e-20f);
      };
      one(0, 0, std::min(1, dims_.x - 1));
#pragma omp simd
      for (int i = 1; i < dims_.x - 1; ++i) one(i, i - 1, i + 1);
      one(dims_.x - 1, std::max(0, dims_.x - 2), dims_.x - 1);
    }
  }

  // flow: u + dt div(c grad u) of one row.
  void flow(const Row& u, const Row& c, float* out) const {
    const auto one = [&](int i, int left, int right) {
      const float x =
          (c.at[i] + c.at[left]) * (u.at[left] - u.at[i]) + (c.at[i] + c.at[right]) * (u.at[right] - u.at[i]);
      const float y =
          (c.at[i] + c.before[i]) * (u.before[i] - u.at[i]) + (c.at[i] + c.after[i]) * (u.after[i] - u.at[i]);
      const float z =
          (c.at[i] + c.below[i]) * (u.below[i] - u.at[i]) + (c.at[i] + c.above[i]) * (u.above[i] - u.at[i]);
      out[i] = u.at[i] + (weight_.x * x + weight_.y * y + weight_.z * z);
    };
    one(0, 0, std::min(1, dims_.x - 1));
#pragma omp simd
    for (int i = 1; i < dims_.x - 1; ++i) one(i, i - 1, i + 1);
    one(dims_.x - 1, std::max(0, dims_.x - 2), dims_.x - 1);
  }

  const Volume<float>& from_;
  Volume<float>& to_;
  glm::ivec3 dims_;
  glm::vec3 scale_, weight_;
  float squaredEdge_;
};

}  // namespace

Volume<float> diffuse(const Volume<float>& volume, const EnhancementOptions& options,
                      const Progress& progress) {
  Volume<float> now = volume, next = Volume<float>::unset(volume.geometry);
  for (int n = 0; n < options.iterations; ++n) {
    const Step step(now, float(options.conductance) * typicalGradient(now), next);
    parallelBlocks(
        std::size_t(volume.geometry.dims.z), kSlab,
        [&](std::size_t first, std::size_t end) { step.run(int(first), int(end)); },
        progress.part(double(n) / options.iterations, double(n + 1) / options.iterations));
    std::swap(now, next);
  }
  return now;
}

}  // namespace sonoskin
