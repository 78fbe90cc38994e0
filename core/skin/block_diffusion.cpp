#include "core/skin/block_diffusion.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/closest_point.h"
#include "core/skin/atlas_reading.h"
#include "core/skin/chart_sides.h"
#include "core/skin/surface_samples.h"
#include "core/skin/triangle_lattice.h"

namespace sonoskin {
namespace {

constexpr int kLevels = PointDiffusion::kLevels;
constexpr std::ptrdiff_t kRun = 16384;  // texels or samples of a task

glm::vec4 colourOf(const glm::vec4& premultiplied) {
  return premultiplied.a > 0 ? glm::vec4(glm::vec3(premultiplied) / premultiplied.a, 1)
                             : glm::vec4(0, 0, 0, 1);
}

// Calls f(i) for i in [0, count) on all threads.
template <class F>
void forEach(std::size_t count, F&& f) {
  const auto all = std::ptrdiff_t(count);
  parallelFor((all + kRun - 1) / kRun, [&](std::ptrdiff_t task) {
    for (std::ptrdiff_t i = task * kRun; i < std::min(all, (task + 1) * kRun); ++i) f(std::size_t(i));
  });
}

}  // namespace

struct BlockDiffusion::State {
  State(std::shared_ptr<const SkinSurface> s, const GaussianSum& p, const Progress& progress)
      : surface(std::move(s)), variances(p.variances), sides(*surface) {
    const Mesh& mesh = *surface->mesh;
    SurfaceSamples samples = sampleSurface(mesh, PointDiffusion::kBaseSpacing, progress.part(0, 0.2));
    for (std::size_t i = 0; i < samples.size(); ++i)
      sampled.push_back(placeInAtlas(surface->atlas.corners[samples.triangles[i]], samples.weights[i]));
    diffusion.emplace(
        AreaPoints{std::move(samples.positions), std::move(samples.normals), std::move(samples.areas)}, p,
        progress.part(0.2, 0.8));
    for (std::size_t i = 1; i <= kLevels; ++i) {
      constexpr double kMostSide = 1.1;  // mm: normals turn too far over more
      const double side = std::min(0.75 * std::sqrt(variances[i]), kMostSide);
      places.emplace_back(mesh, std::max(side, 2 * double(surface->atlas.texel)));
    }
  }

  PointDiffusion::Levels diffuse(const std::vector<glm::vec4>& irradiance, const Progress& progress) const;
  void fill(std::size_t texel, const std::vector<glm::vec4>& irradiance,
            const PointDiffusion::Levels& atPlaces, PointDiffusion::Levels& maps) const;
  void fitSides(int level, const PointDiffusion::Levels& atPlaces, PointDiffusion::Levels& maps) const;

  std::shared_ptr<const SkinSurface> surface;
  std::array<double, GaussianSum::kCount> variances;
  std::vector<glm::vec2> sampled;  // where each sample lies in the atlas
  std::optional<PointDiffusion> diffusion;
  std::vector<TriangleLattice> places;  // where each level is asked
  ChartSides sides;
};

PointDiffusion::Levels BlockDiffusion::State::diffuse(const std::vector<glm::vec4>& irradiance,
                                                      const Progress& progress) const {
  std::vector<glm::vec4> light(sampled.size());
  forEach(sampled.size(), [&](std::size_t i) {
    light[i] = glm::vec4(readAtlas(irradiance, surface->maps.size, sampled[i]), 1);
  });
  PointDiffusion::Levels atPlaces = diffusion->gather(light), maps;
  for (std::size_t i = 0; i < kLevels; ++i) {
    const int level = int(i) + 1;
    if (diffusion->resolves(level))
      atPlaces[i] = diffusion->lightAt(level, atPlaces[i], places[i].positions(), places[i].normals(),
                                       progress.part(0.18 * double(i), 0.18 * double(i + 1)));
    maps[i].resize(irradiance.size());
  }
  forEach(irradiance.size(), [&](std::size_t texel) { fill(texel, irradiance, atPlaces, maps); });
  parallelFor(kLevels, [&](std::ptrdiff_t l) { fitSides(int(l) + 1, atPlaces, maps); });
  return maps;
}

void BlockDiffusion::State::fill(std::size_t texel, const std::vector<glm::vec4>& irradiance,
                                 const PointDiffusion::Levels& atPlaces, PointDiffusion::Levels& maps) const {
  const glm::vec4& shown = surface->maps.position[texel];
  if (shown.w == 0) {
    for (std::vector<glm::vec4>& map : maps) map[texel] = glm::vec4(0);
    return;
  }
  const std::uint32_t t = surface->maps.triangle[texel];
  const std::vector<glm::vec3>& vertices = surface->mesh->positions;
  const Triangle& corners = surface->mesh->triangles[t];
  const glm::vec3 weights = closestPointOnTriangle(glm::vec3(shown), vertices[corners[0]],
                                                   vertices[corners[1]], vertices[corners[2]])
                                .weights;
  for (int i = 0; i < kLevels; ++i) {
    const auto l = std::size_t(i);
    maps[l][texel] = diffusion->resolves(i + 1) ? places[l].value(atPlaces[l], corners, t, weights)
                                                : colourOf(irradiance[texel]);
  }
}

void BlockDiffusion::State::fitSides(int level, const PointDiffusion::Levels& atPlaces,
                                     PointDiffusion::Levels& maps) const {
  if (!diffusion->resolves(level)) return;
  const auto l = std::size_t(level - 1);
  std::vector<glm::vec4> light;
  for (const ChartSides::Place& p : sides.places())
    light.push_back(
        places[l].value(atPlaces[l], surface->mesh->triangles[p.triangle], p.triangle, p.weights));
  sides.fit(light, maps[l]);
}

BlockDiffusion::BlockDiffusion() = default;
BlockDiffusion::~BlockDiffusion() = default;
BlockDiffusion::BlockDiffusion(BlockDiffusion&&) noexcept = default;
BlockDiffusion& BlockDiffusion::operator=(BlockDiffusion&&) noexcept = default;

std::size_t BlockDiffusion::bytes() const {
  if (!state) return 0;
  std::size_t bytes =
      state->diffusion->bytes() + state->sampled.size() * sizeof(glm::vec2) + state->sides.bytes();
  for (const TriangleLattice& places : state->places)
    bytes += places.positions().size() * 2 * sizeof(glm::vec3);
  return bytes;
}

PointDiffusion::Levels diffuseInBlocks(std::shared_ptr<const SkinSurface> surface, const GaussianSum& profile,
                                       const std::vector<glm::vec4>& irradiance, BlockDiffusion& kept,
                                       const Progress& progress) {
  require(irradiance.size() == surface->maps.position.size(),
          "Every texel of the atlas needs an irradiance.");
  if (!kept.state || kept.state->surface != surface || kept.state->variances != profile.variances)
    kept.state = std::make_unique<BlockDiffusion::State>(std::move(surface), profile, progress.part(0, 0.4));
  PointDiffusion::Levels levels = kept.state->diffuse(irradiance, progress.part(0.4, 1));
  progress.update(1);
  return levels;
}

}  // namespace sonoskin
