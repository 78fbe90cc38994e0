#include "core/skin/block_diffusion.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/base/parallel_blocks.h"
#include "core/mesh/closest_point.h"
#include "core/skin/atlas_reading.h"
#include "core/skin/chart_sides.h"
#include "core/skin/surface_samples.h"
#include "core/skin/triangle_lattice.h"

namespace sonoskin {
namespace {

constexpr int kLevels = PointDiffusion::kLevels;
constexpr std::size_t kFewPlaces = 20'000;  // are asked at any cost
constexpr std::size_t kPerTask = 16384;     // texels or samples

glm::vec4 colourOf(const glm::vec4& premultiplied) {
  return premultiplied.a > 0 ? glm::vec4(glm::vec3(premultiplied) / premultiplied.a, 1)
                             : glm::vec4(0, 0, 0, 1);
}

}  // namespace

struct BlockDiffusion::State {
  State(std::shared_ptr<const SkinSurface> s, const GaussianSum& p, const Progress& progress);

  // diffuse: a level's map; `light` is that of the samples.
  std::vector<glm::vec4> diffuse(int level, const std::vector<glm::vec4>& light,
                                 const std::vector<glm::vec4>& irradiance, const Progress& progress) const;
  std::vector<glm::vec4> lightOfSamples(const std::vector<glm::vec4>& irradiance) const;
  AreaPoints sample(const Progress& progress);
  // affordablePlaces: at how many places a level may be asked: in a cloud of loose triangles, which is no surface, at few.
  std::size_t affordablePlaces(int level) const;
  // spreads: whether a level is asked at all, at the vertices at least.
  bool spreads(int level, std::size_t affordable) const {
    return diffusion->resolves(level) && surface->mesh->positions.size() <= std::max(affordable, kFewPlaces);
  }
  glm::vec4 valueAt(std::size_t texel, const TriangleLattice& places,
                    const std::vector<glm::vec4>& atPlaces) const;
  void fitSides(const TriangleLattice& places, const std::vector<glm::vec4>& atPlaces,
                std::vector<glm::vec4>& map) const;

  std::shared_ptr<const SkinSurface> surface;
  std::array<double, GaussianSum::kCount> variances;
  std::vector<glm::vec2> sampled;  // where each sample lies in the atlas
  std::optional<PointDiffusion> diffusion;
  std::vector<std::shared_ptr<const TriangleLattice>> places;  // where each level is asked
  ChartSides sides;
};

BlockDiffusion::State::State(std::shared_ptr<const SkinSurface> s, const GaussianSum& p,
                             const Progress& progress)
    : surface(std::move(s)), variances(p.variances), sides(*surface) {
  diffusion.emplace(sample(progress.part(0, 0.2)), p, progress.part(0.2, 0.8));
  double before = 0;
  for (int level = 1; level <= kLevels; ++level) {
    constexpr double kMostSide = 1.1;  // mm: normals turn too far over more
    const double side = std::max(std::min(0.75 * std::sqrt(variances[std::size_t(level)]), kMostSide),
                                 2 * double(surface->atlas.texel));
    const std::size_t most = affordablePlaces(level);
    places.push_back(!spreads(level, most) ? nullptr
                     : side == before && most >= TriangleLattice::kMost
                         ? places.back()
                         : std::make_shared<const TriangleLattice>(*surface->mesh, side, most));
    before = places.back() && most >= TriangleLattice::kMost ? side : 0;
  }
}

std::size_t BlockDiffusion::State::affordablePlaces(int level) const {
  constexpr double kMostLooks = 4e8;  // at clusters, twice as many as a head needs: 2 s of CPU
  if (!diffusion->resolves(level)) return 0;
  return std::size_t(
      std::min(kMostLooks / std::max(diffusion->meanNeighbours(level), 1.0), double(TriangleLattice::kMost)));
}

AreaPoints BlockDiffusion::State::sample(const Progress& progress) {
  const Mesh& mesh = *surface->mesh;
  const double spacing = affordableSpacing(mesh, PointDiffusion::kBaseSpacing, kMostSamples);
  SurfaceSamples samples = sampleSurface(mesh, spacing, progress);
  sampled.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
    sampled.push_back(placeInAtlas(surface->atlas.corners[samples.triangles[i]], samples.weights[i]));
  return {std::move(samples.positions), std::move(samples.normals), std::move(samples.areas)};
}

std::vector<glm::vec4> BlockDiffusion::State::lightOfSamples(const std::vector<glm::vec4>& irradiance) const {
  std::vector<glm::vec4> light(sampled.size());
  parallelItems(sampled.size(), kPerTask, [&](std::size_t i) {
    light[i] = glm::vec4(readAtlas(irradiance, surface->maps.size, sampled[i]), 1);
  });
  return light;
}

std::vector<glm::vec4> BlockDiffusion::State::diffuse(int level, const std::vector<glm::vec4>& light,
                                                      const std::vector<glm::vec4>& irradiance,
                                                      const Progress& progress) const {
  const std::vector<glm::vec4>& position = surface->maps.position;
  std::vector<glm::vec4> map(irradiance.size());
  if (!places[std::size_t(level - 1)]) {
    parallelItems(map.size(), kPerTask, [&](std::size_t texel) {
      map[texel] = position[texel].w > 0 ? colourOf(irradiance[texel]) : glm::vec4(0);
    });
    return map;
  }
  const TriangleLattice& lattice = *places[std::size_t(level - 1)];
  const std::vector<glm::vec4> atPlaces = diffusion->lightAt(
      level, diffusion->gather(level, light), lattice.positions(), lattice.normals(), progress);
  parallelItems(map.size(), kPerTask, [&](std::size_t texel) {
    map[texel] = position[texel].w > 0 ? valueAt(texel, lattice, atPlaces) : glm::vec4(0);
  });
  fitSides(lattice, atPlaces, map);
  return map;
}

glm::vec4 BlockDiffusion::State::valueAt(std::size_t texel, const TriangleLattice& lattice,
                                         const std::vector<glm::vec4>& atPlaces) const {
  const std::uint32_t t = surface->maps.triangle[texel];
  const std::vector<glm::vec3>& vertices = surface->mesh->positions;
  const Triangle& corners = surface->mesh->triangles[t];
  const glm::vec3 weights =
      closestPointOnTriangle(glm::vec3(surface->maps.position[texel]), vertices[corners[0]],
                             vertices[corners[1]], vertices[corners[2]])
          .weights;
  return lattice.value(atPlaces, corners, t, weights);
}

void BlockDiffusion::State::fitSides(const TriangleLattice& lattice, const std::vector<glm::vec4>& atPlaces,
                                     std::vector<glm::vec4>& map) const {
  std::vector<glm::vec4> light;
  for (const ChartSides::Place& p : sides.places())
    light.push_back(lattice.value(atPlaces, surface->mesh->triangles[p.triangle], p.triangle, p.weights));
  sides.fit(light, map);
}

BlockDiffusion::BlockDiffusion() = default;
BlockDiffusion::~BlockDiffusion() = default;
BlockDiffusion::BlockDiffusion(BlockDiffusion&&) noexcept = default;
BlockDiffusion& BlockDiffusion::operator=(BlockDiffusion&&) noexcept = default;

std::size_t BlockDiffusion::placesAsked(int level) const {
  const auto places = state ? state->places[std::size_t(level - 1)] : nullptr;
  return places ? places->positions().size() : 0;
}

std::size_t BlockDiffusion::bytes() const {
  if (!state) return 0;
  std::size_t bytes =
      state->diffusion->bytes() + state->sampled.size() * sizeof(glm::vec2) + state->sides.bytes();
  const TriangleLattice* before = nullptr;
  for (const auto& places : state->places) {
    if (places && places.get() != before) bytes += places->positions().size() * 2 * sizeof(glm::vec3);
    before = places.get();
  }
  return bytes;
}

void diffuseInBlocks(std::shared_ptr<const SkinSurface> surface, const GaussianSum& profile,
                     const std::vector<glm::vec4>& irradiance, BlockDiffusion& kept, const TakeLevel& take,
                     const Progress& progress) {
  require(irradiance.size() == surface->maps.position.size(),
          "Every texel of the atlas needs an irradiance.");
  if (!kept.state || kept.state->surface != surface || kept.state->variances != profile.variances)
    kept.state = std::make_unique<BlockDiffusion::State>(std::move(surface), profile, progress.part(0, 0.4));
  const std::vector<glm::vec4> light = kept.state->lightOfSamples(irradiance);
  for (int level = 1; level <= kLevels; ++level) {
    const Progress part = progress.part(0.28 + 0.12 * level, 0.4 + 0.12 * level);
    std::vector<glm::vec4> map = kept.state->diffuse(level, light, irradiance, part);
    take(level, map);
    part.update(1);
  }
}

PointDiffusion::Levels diffuseInBlocks(std::shared_ptr<const SkinSurface> surface, const GaussianSum& profile,
                                       const std::vector<glm::vec4>& irradiance, BlockDiffusion& kept,
                                       const Progress& progress) {
  PointDiffusion::Levels levels;
  diffuseInBlocks(
      std::move(surface), profile, irradiance, kept,
      [&](int level, std::vector<glm::vec4>& map) { levels[std::size_t(level - 1)] = std::move(map); },
      progress);
  return levels;
}

}  // namespace sonoskin
