#include "core/skin/block_diffusion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/raster.h"
#include "core/skin/atlas_reading.h"
#include "core/skin/surface_samples.h"
#include "core/skin/triangle_lattice.h"

namespace sonoskin {
namespace {

constexpr int kLevels = PointDiffusion::kLevels;
constexpr std::uint32_t kNoTriangle = std::numeric_limits<std::uint32_t>::max();
constexpr std::ptrdiff_t kRun = 16384;  // texels or samples of a task

// The weights of a triangle's corners at a place of the atlas, or at about the nearest place of its sides.
glm::vec3 weightsInside(const Barycentric& weights, const glm::vec2& place) {
  const glm::vec3 w = glm::max(weights.at(place), glm::vec3(0));
  return w / (w.x + w.y + w.z);
}

glm::vec2 middleOf(int x, int y) { return {float(x) + 0.5f, float(y) + 0.5f}; }

// The triangle that each texel shows: of those around it the one that comes nearest to the place in its map.
std::vector<std::uint32_t> trianglesOfTexels(const SkinSurface& surface) {
  const glm::ivec2 size = surface.maps.size;
  const std::vector<glm::vec3>& vertices = surface.mesh->positions;
  std::vector<std::uint32_t> triangles(surface.maps.position.size(), kNoTriangle);
  std::vector<float> nearest(triangles.size(), std::numeric_limits<float>::max());
  for (std::uint32_t t = 0; t < surface.atlas.corners.size(); ++t) {
    const Corners& c = surface.atlas.corners[t];
    const auto& [i, j, k] = surface.mesh->triangles[t];
    const Barycentric weights(c);
    if (!weights.valid()) continue;
    const glm::ivec2 low =
        glm::max(glm::ivec2(glm::floor(glm::min(glm::min(c[0], c[1]), c[2]))), glm::ivec2(0));
    const glm::ivec2 high = glm::min(glm::ivec2(glm::ceil(glm::max(glm::max(c[0], c[1]), c[2]))), size);
    for (int y = low.y; y < high.y; ++y)
      for (int x = low.x; x < high.x; ++x) {
        const std::size_t texel = std::size_t(y) * std::size_t(size.x) + std::size_t(x);
        const glm::vec4& shown = surface.maps.position[texel];
        if (shown.w == 0) continue;
        const glm::vec3 w = weightsInside(weights, middleOf(x, y));
        const float away =
            glm::distance(w.x * vertices[i] + w.y * vertices[j] + w.z * vertices[k], glm::vec3(shown));
        if (away >= nearest[texel]) continue;
        nearest[texel] = away;
        triangles[texel] = t;
      }
  }
  return triangles;
}

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

// How one level is read back into the atlas.
struct Reading {
  TriangleLattice places;
  SparseRows rows;
};

}  // namespace

struct BlockDiffusion::State {
  State(std::shared_ptr<const SkinSurface> s, const GaussianSum& p, const Progress& progress)
      : surface(std::move(s)), variances(p.variances), triangles(trianglesOfTexels(*surface)) {
    const Mesh& mesh = *surface->mesh;
    SurfaceSamples samples = sampleSurface(mesh, PointDiffusion::kBaseSpacing, progress.part(0, 0.1));
    for (std::size_t i = 0; i < samples.size(); ++i)
      sampled.push_back(placeInAtlas(surface->atlas.corners[samples.triangles[i]], samples.weights[i]));
    diffusion.emplace(
        AreaPoints{std::move(samples.positions), std::move(samples.normals), std::move(samples.areas)}, p,
        progress.part(0.1, 0.7));
    for (int i = 1; i <= kLevels; ++i) {
      constexpr double kLeastSide = 0.8;  // mm: shorter ones tell no more than the points do
      TriangleLattice places(mesh, std::max(kLeastSide, 1.5 * std::sqrt(variances[std::size_t(i)])));
      SparseRows rows = diffusion->rowsTo(i, places.positions(), places.normals(),
                                          progress.part(0.7 + 0.06 * (i - 1), 0.7 + 0.06 * i));
      readings.push_back({std::move(places), std::move(rows)});
    }
  }

  void diffuse(const std::vector<glm::vec4>& irradiance);
  void fill(std::size_t texel, const std::vector<glm::vec4>& irradiance,
            const PointDiffusion::Levels& atPlaces);

  std::shared_ptr<const SkinSurface> surface;
  std::array<double, GaussianSum::kCount> variances;
  std::vector<std::uint32_t> triangles;  // per texel
  std::vector<glm::vec2> sampled;        // where each sample lies in the atlas
  std::optional<PointDiffusion> diffusion;
  std::vector<Reading> readings;  // per level
  PointDiffusion::Levels maps;
};

void BlockDiffusion::State::diffuse(const std::vector<glm::vec4>& irradiance) {
  std::vector<glm::vec4> light(sampled.size());
  forEach(sampled.size(), [&](std::size_t i) {
    light[i] = glm::vec4(readAtlas(irradiance, surface->maps.size, sampled[i]), 1);
  });
  PointDiffusion::Levels atPlaces = diffusion->diffuse(light);
  for (std::size_t i = 0; i < kLevels; ++i) {
    atPlaces[i] = multiply(readings[i].rows, atPlaces[i]);
    maps[i].resize(irradiance.size());
  }
  forEach(irradiance.size(), [&](std::size_t texel) { fill(texel, irradiance, atPlaces); });
}

void BlockDiffusion::State::fill(std::size_t texel, const std::vector<glm::vec4>& irradiance,
                                 const PointDiffusion::Levels& atPlaces) {
  const std::uint32_t t = triangles[texel];
  if (t == kNoTriangle) {
    for (std::vector<glm::vec4>& map : maps) map[texel] = glm::vec4(0);
    return;
  }
  const auto width = std::size_t(surface->maps.size.x);
  const glm::vec3 weights =
      weightsInside(Barycentric(surface->atlas.corners[t]), middleOf(int(texel % width), int(texel / width)));
  for (int i = 0; i < kLevels; ++i) {
    const auto l = std::size_t(i);
    maps[l][texel] = diffusion->resolves(i + 1)
                         ? readings[l].places.value(atPlaces[l], surface->mesh->triangles[t], t, weights)
                         : colourOf(irradiance[texel]);
  }
}

BlockDiffusion::BlockDiffusion() = default;
BlockDiffusion::~BlockDiffusion() = default;
BlockDiffusion::BlockDiffusion(BlockDiffusion&&) noexcept = default;
BlockDiffusion& BlockDiffusion::operator=(BlockDiffusion&&) noexcept = default;

std::size_t BlockDiffusion::bytes() const {
  if (!state) return 0;
  std::size_t bytes = state->diffusion->bytes() + state->triangles.size() * sizeof(std::uint32_t) +
                      state->sampled.size() * sizeof(glm::vec2);
  for (const Reading& reading : state->readings)
    bytes += reading.rows.bytes() + reading.places.positions().size() * 2 * sizeof(glm::vec3);
  for (const std::vector<glm::vec4>& map : state->maps) bytes += map.size() * sizeof(glm::vec4);
  return bytes;
}

const PointDiffusion::Levels& diffuseInBlocks(std::shared_ptr<const SkinSurface> surface,
                                              const GaussianSum& profile,
                                              const std::vector<glm::vec4>& irradiance, BlockDiffusion& kept,
                                              const Progress& progress) {
  require(irradiance.size() == surface->maps.position.size(),
          "Every texel of the atlas needs an irradiance.");
  if (!kept.state || kept.state->surface != surface || kept.state->variances != profile.variances)
    kept.state = std::make_unique<BlockDiffusion::State>(std::move(surface), profile, progress.part(0, 0.95));
  kept.state->diffuse(irradiance);
  progress.update(1);
  return kept.state->maps;
}

}  // namespace sonoskin
