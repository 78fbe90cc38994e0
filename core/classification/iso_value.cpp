#include "core/classification/iso_value.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"
#include "core/volume/sample.h"

namespace sonoskin {
namespace {

constexpr double kSamples = 230'000;  // about so many voxels are looked at, evenly spread
constexpr float kMargin = 6;          // voxels from the recording's side, whose edge the low-pass blurs
constexpr double kEdgeShare = 0.02;   // of them the steepest count as edges
constexpr float kFacing = 0.3f;       // least cosine between gradient and beam at an edge of the skin
constexpr double kIsoShare = 0.2, kVisibleShare = 0.6;  // of the way from the fluid to the edges

struct Sample {
  float grey, gradient;
  bool facing;  // dark to bright along the beam
};

Sample sampleAt(const Volume<float>& volume, const Beam& beam, const glm::ivec3& voxel) {
  const Geometry& g = volume.geometry;
  const std::size_t index = g.index(voxel.x, voxel.y, voxel.z);
  const glm::vec3 gradient = gradientAt(volume, g.axisScale(), index);
  const glm::vec3 along(glm::transpose(g.direction) * beam.directionAt(g.toWorld(glm::dvec3(voxel))));
  const float length = glm::length(gradient);
  return {volume.data[index], length, glm::dot(gradient, along) > kFacing * length};
}

std::vector<Sample> takeSamples(const Volume<float>& volume, const FieldOfView& view, const Beam& beam) {
  const Geometry& g = volume.geometry;
  const int stride = std::max(1, int(std::cbrt(double(g.voxels()) / kSamples)));
  const int slices = (g.dims.z - 2 + stride - 1) / stride;
  const auto margin = kMargin * float(g.minSpacing());
  std::vector<std::vector<Sample>> perSlice(std::size_t(std::max(0, slices)));
  parallelFor(slices, [&](std::ptrdiff_t slice) {
    const int k = 1 + int(slice) * stride;
    for (int j = 1; j < g.dims.y - 1; j += stride)
      for (int i = 1; i < g.dims.x - 1; i += stride) {
        const glm::vec3 position = glm::vec3(i, j, k) * glm::vec3(g.spacing);
        if (view.contains(position) && view.depth(position) >= margin)
          perSlice[std::size_t(slice)].push_back(sampleAt(volume, beam, {i, j, k}));
      }
  });
  std::vector<Sample> samples;
  for (const auto& some : perSlice) samples.insert(samples.end(), some.begin(), some.end());
  return samples;
}

// The gradient that all but the steepest samples stay below.
float steep(const std::vector<Sample>& samples) {
  std::vector<float> gradients;
  gradients.reserve(samples.size());
  for (const Sample& s : samples) gradients.push_back(s.gradient);
  const auto border = gradients.begin() + std::ptrdiff_t((1 - kEdgeShare) * double(gradients.size() - 1));
  std::nth_element(gradients.begin(), border, gradients.end());
  return *border;
}

// The mean of what `weight` gives each sample; `otherwise` where nothing has weight.
template <class Weight>
double meanGrey(const std::vector<Sample>& samples, double otherwise, const Weight& weight) {
  double sum = 0, weights = 0;
  for (const Sample& s : samples) {
    const double w = weight(s);
    sum += w * double(s.grey), weights += w;
  }
  return weights > 0 ? sum / weights : otherwise;
}

}  // namespace

GreyLevels proposeLevels(const Volume<float>& lowPassed, const FieldOfView& view, const Beam& beam) {
  const std::vector<Sample> samples = takeSamples(lowPassed, view, beam);
  if (samples.empty()) return {};
  const float least = steep(samples);
  const double edge = meanGrey(samples, 0.5, [&](const Sample& s) {
    return s.facing && s.gradient >= least ? double(s.gradient) : 0.0;
  });
  const double fluid =
      meanGrey(samples, 0, [&](const Sample& s) { return double(s.grey) < edge ? 1.0 : 0.0; });
  const auto between = [&](double share) {
    return float(std::clamp(fluid + share * (edge - fluid), 0.02, 0.98));
  };
  return {between(kIsoShare), between(kVisibleShare)};
}

}  // namespace sonoskin
