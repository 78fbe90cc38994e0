#include "core/mesh/facts/mesh_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/error.h"

namespace sonoskin {
namespace {

constexpr float kSmallest = 20, kLargest = 1000;  // mm
constexpr double kInward = -0.01;                 // of the cube of the diagonal: flat surfaces are not told
constexpr float kOtherUnit = 5;

// Of the cones from the middle of the box to the triangles; > 0 where they look away from it.
double volumeAround(const Mesh& mesh, const glm::vec3& middle) {
  double sum = 0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[i] - middle), b(mesh.positions[j] - middle),
        c(mesh.positions[k] - middle);
    sum += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return sum;
}

}  // namespace

std::vector<std::string> meshDoubts(const Mesh& mesh) {
  std::vector<std::string> doubts;
  const Box box = boundingBox(mesh.positions);
  const float size = box.diagonal();
  if (size < kSmallest || size > kLargest)
    doubts.push_back(
        fmt::format("the surface is {:.3g} mm across, which no face is: if its file is in another unit, "
                    "render it with --scale, "
                    "such as 1000 for metres",
                    double(size)));
  if (volumeAround(mesh, box.centre()) < kInward * double(size) * double(size) * double(size))
    doubts.push_back(
        "the surface looks inward: if it is dark, its triangles are turned over: render it with --flip");
  return doubts;
}

std::vector<std::string> pairDoubts(const Mesh& a, const Mesh& b) {
  std::vector<std::string> doubts;
  const Box first = boundingBox(a.positions), second = boundingBox(b.positions);
  const float ratio = first.diagonal() / second.diagonal();
  if (ratio > kOtherUnit || ratio < 1 / kOtherUnit)
    doubts.push_back(
        fmt::format("one surface is {:.3g} times as large as the other: they may have different units",
                    double(ratio > 1 ? ratio : 1 / ratio)));
  if (!overlap(first, second))
    doubts.push_back("the surfaces lie apart: they may not share a frame, such as RAS and LPS");
  return doubts;
}

void requireExtent(const Mesh& mesh, const std::string& name) {
  constexpr double kFarthest = 1e7, kLargest = 1e5;  // mm
  const Box box = boundingBox(mesh.positions);
  const glm::vec3 corner = glm::max(glm::abs(box.min), glm::abs(box.max));
  const double farthest = double(std::max({corner.x, corner.y, corner.z})),
               across = glm::length(glm::dvec3(box.max) - glm::dvec3(box.min));
  require(across <= kLargest, "{} is {:.3g} m across, which no surface of a body is; check its unit.", name,
          across / 1000);
  require(farthest <= kFarthest, "{} lies {:.3g} m away from its origin, where no body is; check its unit.",
          name, farthest / 1000);
}

void scaleMesh(Mesh& mesh, float factor) {
  for (glm::vec3& p : mesh.positions) p *= factor;
  requireExtent(mesh, fmt::format("the surface, {:g} times as large,", double(factor)));
}

void flipMesh(Mesh& mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  for (auto& uvs : mesh.cornerUvs) std::swap(uvs[1], uvs[2]);
  for (glm::vec3& n : mesh.normals) n = -n;
}

}  // namespace sonoskin
