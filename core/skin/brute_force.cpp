#include "core/skin/brute_force.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel_blocks.h"
#include "core/mesh/search/point_grid.h"

namespace sonoskin {
namespace {

constexpr int kCount = GaussianSum::kCount;
constexpr float kWidths = 4;  // a Gaussian beyond them holds 0.03 %
constexpr std::size_t kTargetsPerTask = 8;

struct Sample {
  glm::vec3 position, normal, power;  // power: irradiance times area
  float area;
};

// The samples in the order of a grid, so that a query reads memory in runs.
struct Cloud {
  PointGrid grid;
  std::vector<Sample> samples;
};

Cloud sortSamples(const SurfaceSamples& samples, std::span<const glm::vec3> irradiance, float cell) {
  Cloud cloud{PointGrid(samples.positions, cell), {}};
  cloud.samples.reserve(samples.size());
  for (const std::uint32_t i : cloud.grid.order())
    cloud.samples.push_back(
        {samples.positions[i], samples.normals[i], samples.areas[i] * irradiance[i], samples.areas[i]});
  return cloud;
}

// The Gaussians that the samples resolve, from number `first` on.
struct Kernel {
  int first = 0;
  std::array<float, kCount> squaredReach{}, exponent{};
};

Kernel kernelOf(const GaussianSum& profile, double spacing) {
  Kernel kernel;
  while (kernel.first < kCount && !isResolved(profile.variances[std::size_t(kernel.first)], spacing))
    ++kernel.first;
  for (auto i = std::size_t(kernel.first); i < kCount; ++i) {
    kernel.squaredReach[i] = kWidths * kWidths * float(profile.variances[i]);
    kernel.exponent[i] = float(-0.5 / profile.variances[i]);
  }
  return kernel;
}

struct Sums {
  std::array<glm::dvec3, kCount> power{};
  std::array<double, kCount> area{};  // of the local samples
};

void add(const Sample& sample, const DiffusionTarget& target, const Kernel& kernel, Reach reach, Sums& sums) {
  const glm::vec3 d = sample.position - target.position;
  const float squared = glm::dot(d, d);
  if (squared > kernel.squaredReach[kCount - 1]) return;
  const bool local = isLocal(sample.normal, target.normal);
  if (!local && reach == Reach::local) return;
  for (int i = kCount - 1; i >= kernel.first; --i) {  // the widest first: where it ends all narrower ones do
    const auto q = std::size_t(i);
    if (squared > kernel.squaredReach[q]) break;
    const float weight = std::exp(squared * kernel.exponent[q]);
    sums.power[q] += glm::dvec3(weight * sample.power);
    if (local) sums.area[q] += double(weight * sample.area);
  }
}

DiffusedLevels integrate(const DiffusionTarget& target, const Cloud& cloud, const Kernel& kernel,
                         Reach reach) {
  DiffusedLevels levels;
  levels.fill(target.irradiance);
  if (kernel.first == kCount) return levels;
  Sums sums;
  const float radius = std::sqrt(kernel.squaredReach[kCount - 1]);
  cloud.grid.forEachRun(target.position, radius, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) add(cloud.samples[s], target, kernel, reach, sums);
  });
  for (auto i = std::size_t(kernel.first); i < kCount; ++i)
    if (sums.area[i] > 0) levels[i] = glm::vec3(sums.power[i] / sums.area[i]);
  return levels;
}

}  // namespace

glm::vec3 sumOfLevels(const GaussianSum& profile, const DiffusedLevels& levels) {
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < kCount; ++i) sum += profile.weights[i] * glm::dvec3(levels[i]);
  return glm::vec3(sum);
}

std::vector<DiffusedLevels> bruteForceDiffusion(const SurfaceSamples& samples,
                                                std::span<const glm::vec3> irradiance,
                                                const GaussianSum& profile,
                                                std::span<const DiffusionTarget> targets, Reach reach,
                                                const Progress& progress) {
  require(irradiance.size() == samples.size(), "Every sample of the surface needs an irradiance.");
  const Kernel kernel = kernelOf(profile, double(samples.spacing));
  const float radius = std::sqrt(kernel.squaredReach[kCount - 1]);
  const Cloud cloud = sortSamples(samples, irradiance, std::max(0.15f * radius, 0.1f));
  std::vector<DiffusedLevels> result(targets.size());
  parallelItems(
      targets.size(), kTargetsPerTask,
      [&](std::size_t t) { result[t] = integrate(targets[t], cloud, kernel, reach); }, progress);
  return result;
}

}  // namespace sonoskin
