#include "core/skin/triangle_lattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace sonoskin {
namespace {

std::span<const Triangle> shownOf(const Mesh& mesh, std::size_t shown) {
  return std::span(mesh.triangles).first(std::min(shown, mesh.triangles.size()));
}

// They use the first vertices.
std::size_t verticesOf(std::span<const Triangle> triangles) {
  std::size_t count = 0;
  for (const Triangle& t : triangles) count = std::max<std::size_t>(count, std::ranges::max(t) + 1u);
  return count;
}

}  // namespace

TriangleLattice::Net TriangleLattice::netOf(const Mesh& mesh, const Triangle& t, double longest) {
  constexpr double kMostParts = 128, kMostRows = 65536;
  // A triangle of so many parts along its sides whose shortest side is below so many times `longest` is a sliver.
  constexpr double kSliverParts = 16, kSliverWidth = 0.5;
  const glm::vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
  const std::array<float, 3> across{glm::distance(b, c), glm::distance(c, a), glm::distance(a, b)};
  const auto [shortest, side] = std::ranges::minmax_element(across);
  const double parts = std::ceil(double(*side) / longest);
  Net net;
  if (parts >= kSliverParts && double(*shortest) < kSliverWidth * longest)
    net.tip = std::uint32_t(shortest - across.begin());
  net.parts = std::uint32_t(std::clamp(parts, 1.0, net.tip < 3 ? kMostRows : kMostParts));
  return net;
}

void TriangleLattice::add(const Mesh& mesh, const Triangle& t, const glm::vec3& w) {
  const auto mix = [&](const std::vector<glm::vec3>& of) {
    return w.x * of[t[0]] + w.y * of[t[1]] + w.z * of[t[2]];
  };
  positions_.push_back(mix(mesh.positions));
  const glm::vec3 normal = mix(mesh.normals);
  const float length = glm::length(normal);
  normals_.push_back(length > 0 ? normal / length : mesh.normals[t[0]]);
}

void TriangleLattice::addPlaces(const Mesh& mesh, const Triangle& t, const Net& net) {
  const std::uint32_t n = net.parts;
  if (net.tip < 3) {
    for (std::uint32_t row = 0; row <= n; ++row)
      for (const std::uint32_t side : {1u, 2u}) {
        glm::vec3 weights(0);
        weights[int(net.tip)] = float(n - row) / float(n);
        weights[int((net.tip + side) % 3)] = float(row) / float(n);
        add(mesh, t, weights);
      }
    return;
  }
  for (std::uint32_t v = 0; v <= n; ++v)
    for (std::uint32_t u = 0; u + v <= n; ++u)
      add(mesh, t, {float(n - u - v) / float(n), float(u) / float(n), float(v) / float(n)});
}

std::uint64_t TriangleLattice::placesOf(const Mesh& mesh, double longest, std::size_t shown) {
  const std::span triangles = shownOf(mesh, shown);
  std::uint64_t places = verticesOf(triangles);
  for (const Triangle& t : triangles) places += netOf(mesh, t, longest).places();
  return places;
}

TriangleLattice::TriangleLattice(const Mesh& mesh, double longest, std::size_t most, std::size_t shown) {
  constexpr double kLonger = 1.15;
  const std::span triangles = shownOf(mesh, shown);
  const std::size_t vertices = verticesOf(triangles);
  positions_.assign(mesh.positions.begin(), mesh.positions.begin() + std::ptrdiff_t(vertices));
  normals_.assign(mesh.normals.begin(), mesh.normals.begin() + std::ptrdiff_t(vertices));
  std::uint64_t places = 0;
  do {
    nets_.clear();
    places = 0;
    for (const Triangle& t : triangles) places += nets_.emplace_back(netOf(mesh, t, longest)).places();
    longest *= kLonger;
  } while (places > most);
  positions_.reserve(positions_.size() + places);
  normals_.reserve(normals_.size() + places);
  for (std::size_t i = 0; i < nets_.size(); ++i) {
    nets_[i].first = std::uint32_t(positions_.size());
    if (nets_[i].parts > 1) addPlaces(mesh, mesh.triangles[i], nets_[i]);
  }
}

}  // namespace sonoskin
