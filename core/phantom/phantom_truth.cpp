#include <algorithm>
#include <cmath>

#include "core/base/parallel_blocks.h"
#include "core/mesh/iso/marching_cubes.h"
#include "core/phantom/acoustics.h"
#include "core/phantom/phantom.h"
#include "core/phantom/phantom_geometry.h"

namespace sonoskin {
namespace {

constexpr float kFacing = 0.25f;  // least cosine between the normal and the way back to the probe
constexpr float kShadow = 8;      // dB of loss, there and back, from which skin lies in a shadow
constexpr float kBorder = 1;      // mm within the sector and the field of view
constexpr float kClear = 0.8f;    // mm of fluid before skin that can be told from what lies on it
constexpr std::size_t kVerticesPerTask = 4096;

// boxDistance: to the border of the field of view, negative inside.
double boxDistance(const glm::dvec3& p) {
  const glm::dvec3 beyond = glm::abs(p - 0.5 * kFieldOfView) - 0.5 * kFieldOfView;
  return std::max({beyond.x, beyond.y, beyond.z});
}

// clipToView: closes the baby where it leaves the field of view.
Volume<float> clipToView(Volume<float> skin, const Progress& progress) {
  const Geometry g = skin.geometry;
  parallelFor(
      g.dims.z,
      [&](std::ptrdiff_t k) {
        for (int j = 0; j < g.dims.y; ++j)
          for (int i = 0; i < g.dims.x; ++i) {
            float& d = skin.at(i, j, int(k));
            d = std::max(d, float(boxDistance(g.toWorld({i, j, k}))));
          }
      },
      progress);
  return skin;
}

template <class Distance>
glm::dvec3 gradientOf(Distance&& distance, const glm::dvec3& p) {
  constexpr double h = 0.02;
  glm::dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0);
    step[axis] = h;
    gradient[axis] = (distance(p + step) - distance(p - step)) / (2 * h);
  }
  return gradient;
}

// Truth: finishes the vertices of a mesh one by one.
class Truth {
 public:
  Truth(const SectorGrid& sector, const PhantomModel& model, const TissueDistances& tissues)
      : sector_(sector), model_(model), tissues_(tissues) {}

  // finish: moves a vertex of the skin onto the exact surface, and finds its normal, visibility and label.
  void finish(Mesh& mesh, std::size_t v) const {
    glm::dvec3 p(mesh.positions[v]);
    const bool cap = boxDistance(p) > -1e-3;
    const auto skin = [&](const glm::dvec3& q) { return model_.skin(q); };
    const glm::dvec3 gradient = cap ? gradientOf(boxDistance, p) : gradientOf(skin, p);
    if (!cap) p -= gradient * (skin(p) / std::max(glm::dot(gradient, gradient), 0.25));
    mesh.positions[v] = glm::vec3(p);
    mesh.normals[v] = glm::vec3(glm::normalize(gradient));
    mesh.visibility[v] = !cap && seen(mesh.positions[v], mesh.normals[v]) ? 1.f : 0.f;
    mesh.labels[v] = std::uint8_t(model_.part(p));
  }

 private:
  bool seen(const glm::vec3& p, const glm::vec3& normal) const {
    if (boxDistance(p) > -double(kBorder) || !sector_.contains(p, kBorder)) return false;
    if (glm::dot(normal, glm::normalize(sector_.apex - p)) <= kFacing) return false;
    if (model_.isCrowded() && isCovered(p, normal)) return false;
    return lossBefore(sector_, tissues_, p) < kShadow;
  }

  bool isCovered(const glm::vec3& p, const glm::vec3& normal) const {
    return model_.other(glm::dvec3(p)) < 0 || model_.other(glm::dvec3(p + kClear * normal)) < 0;
  }

  const SectorGrid& sector_;
  const PhantomModel& model_;
  const TissueDistances tissues_;
};

}  // namespace

Mesh makePhantomTruth(const PhantomOptions& options, const Progress& progress) {
  const Geometry voxels = phantomGeometry(options);
  const Geometry grid = anatomyGrid(anatomySpacing(voxels));
  const PhantomModel model(options);
  const DistanceGrid skin = sampled(model, &PhantomModel::skin, grid, 2.5, progress.part(0, 0.5));
  const DistanceGrid wall = sampled(model, &PhantomModel::wall, grid, 1, progress.part(0.5, 0.53));
  std::optional<DistanceGrid> strands;
  if (model.hasStrands())
    strands = sampled(model, &PhantomModel::strands, grid, 2.5, progress.part(0.53, 0.55));
  Mesh mesh = marchingCubes(clipToView(skin.samples(), progress.part(0.55, 0.6)), 0, progress.part(0.6, 0.7));
  mesh.normals.resize(mesh.positions.size());
  mesh.visibility.resize(mesh.positions.size());
  mesh.labels.resize(mesh.positions.size());
  const SectorGrid sector = sceneSector(options);
  const Truth truth(sector, model, {skin, wall, strands ? &*strands : nullptr});
  parallelItems(
      mesh.positions.size(), kVerticesPerTask, [&](std::size_t v) { truth.finish(mesh, v); },
      progress.part(0.7, 1));
  return mesh;
}

}  // namespace sonoskin
