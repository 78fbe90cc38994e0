#include "core/skin/hierarchical_integral.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace sonoskin {
namespace {

constexpr int kLevels = 16;  // of the octree
constexpr std::uint32_t kSamplesOfLeaf = 8;

// Three bits for each level of the tree, the root's first.
std::uint64_t cellCode(const glm::vec3& position, const Box& box) {
  const glm::vec3 extent = box.max - box.min;
  const float scale = float(1 << kLevels) / std::max({extent.x, extent.y, extent.z, 1e-6f});
  const glm::ivec3 cell =
      glm::clamp(glm::ivec3((position - box.min) * scale), glm::ivec3(0), glm::ivec3((1 << kLevels) - 1));
  std::uint64_t code = 0;
  for (int bit = kLevels - 1; bit >= 0; --bit)
    code =
        code << 3 | std::uint64_t((cell.z >> bit & 1) << 2 | (cell.y >> bit & 1) << 1 | (cell.x >> bit & 1));
  return code;
}

}  // namespace

struct HierarchicalIntegral::Accumulator {
  const glm::vec3 position, normal;
  const RadialProfile& profile;
  const Reach reach;
  const bool normalised;
  glm::dvec3 light{0}, unit{0};

  void add(const Source& place) {
    const bool local = isLocal(place.normal, normal);
    if (!local && reach == Reach::local) return;
    const glm::vec3 toPower = place.powerPosition - position;
    const glm::vec3 value = profile(glm::dot(toPower, toPower));
    light += glm::dvec3(value * place.power);
    if (!normalised || !local) return;
    if (place.powerPosition == place.position) {
      unit += glm::dvec3(value * place.area);
    } else {
      const glm::vec3 toArea = place.position - position;
      unit += glm::dvec3(profile(glm::dot(toArea, toArea)) * place.area);
    }
  }
};

HierarchicalIntegral::HierarchicalIntegral(const SurfaceSamples& samples,
                                           std::span<const glm::vec3> irradiance) {
  require(samples.size() > 0, "An integral over a surface needs samples.");
  require(irradiance.size() == samples.size(), "Every sample of the surface needs an irradiance.");
  const Box box = boundingBox(samples.positions);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order(samples.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = {cellCode(samples.positions[i], box), i};
  std::sort(order.begin(), order.end());
  std::vector<std::uint64_t> codes;
  codes.reserve(order.size());
  samples_.reserve(order.size());
  for (const auto& [code, i] : order) {
    codes.push_back(code);
    samples_.push_back({samples.positions[i], samples.normals[i], samples.areas[i] * irradiance[i],
                        samples.positions[i], samples.areas[i]});
  }
  nodes_.reserve(order.size() / 2);
  build(0, std::uint32_t(order.size()), 1, codes);
}

// A run of samples as one: where its area and where its light is.
HierarchicalIntegral::Source HierarchicalIntegral::merged(std::uint32_t first, std::uint32_t last) const {
  double area = 0, brightness = 0;
  glm::dvec3 place(0), normal(0), power(0), powerPlace(0);
  for (std::uint32_t s = first; s < last; ++s) {
    const Source& p = samples_[s];
    const glm::dvec3 position(p.position);
    const double bright = double(p.power.x) + double(p.power.y) + double(p.power.z);
    area += double(p.area), place += double(p.area) * position;
    brightness += bright, powerPlace += bright * position;
    normal += double(p.area) * glm::dvec3(p.normal), power += glm::dvec3(p.power);
  }
  Source result;
  result.area = float(area);
  result.position = area > 0 ? glm::vec3(place / area) : samples_[first].position;
  result.normal = glm::vec3(normal / std::max(glm::length(normal), 1e-12));
  result.power = glm::vec3(power);
  result.powerPosition = brightness > 0 ? glm::vec3(powerPlace / brightness) : result.position;
  return result;
}

void HierarchicalIntegral::build(std::uint32_t first, std::uint32_t last, int level,
                                 std::span<const std::uint64_t> codes) {
  const std::size_t number = nodes_.size();
  nodes_.push_back({merged(first, last), first, 0, 0});
  if (last - first <= kSamplesOfLeaf || level > kLevels) {
    nodes_[number].count = last - first;
  } else {
    const int shift = 3 * (kLevels - level);
    for (std::uint32_t begin = first; begin < last;) {
      const auto sameCell = [&](std::uint64_t code) { return code >> shift == codes[begin] >> shift; };
      const auto end = std::partition_point(codes.begin() + begin, codes.begin() + last, sameCell);
      const auto after = std::uint32_t(end - codes.begin());
      build(begin, after, level + 1, codes);
      begin = after;
    }
  }
  nodes_[number].next = std::uint32_t(nodes_.size());
}

glm::vec3 HierarchicalIntegral::at(const glm::vec3& position, const glm::vec3& normal,
                                   const RadialProfile& profile, const IntegralOptions& options) const {
  Accumulator sums{position, normal, profile, options.reach, options.normalised};
  const auto eps = float(options.eps);
  for (std::uint32_t i = 0; i < nodes_.size();) {
    const Node& node = nodes_[i];
    const glm::vec3 d = node.source.position - position;
    if (node.source.area < eps * glm::dot(d, d)) {
      sums.add(node.source);
      i = node.next;
    } else if (node.count > 0) {
      for (std::uint32_t s = node.first; s < node.first + node.count; ++s) sums.add(samples_[s]);
      i = node.next;
    } else {
      ++i;
    }
  }
  if (!options.normalised) return glm::vec3(sums.light);
  glm::dvec3 light(0);
  for (int c = 0; c < 3; ++c)
    if (sums.unit[c] > 0) light[c] = sums.light[c] * profile.total()[c] / sums.unit[c];
  return glm::vec3(light);
}

}  // namespace sonoskin
