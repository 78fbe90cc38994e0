#include "core/skin/block_diffusion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <ranges>

#include "core/base/error.h"
#include "core/base/parallel_blocks.h"
#include "core/skin/atlas_reading.h"
#include "core/skin/chart_sides.h"
#include "core/skin/shown_places.h"
#include "core/skin/surface_samples.h"
#include "core/skin/triangle_lattice.h"

namespace sonoskin {
namespace {

constexpr int kLevels = PointDiffusion::kLevels;
constexpr std::size_t kFewPlaces = 20'000;  // are asked at any cost
constexpr std::size_t kPerTask = 16384;     // texels or samples

// What is entered at a place of the atlas; thinness in a.
glm::vec4 lightAt(const EnteredLight& entered, const glm::ivec2& size, const glm::vec2& place) {
  return {readAtlas(entered.irradiance, size, place),
          entered.thinness.empty() ? 1 : readAtlas(entered.thinness, size, place).r};
}

glm::vec2 middleOf(std::uint32_t texel, const glm::ivec2& size) {
  return {float(texel % std::uint32_t(size.x)) + 0.5f, float(texel / std::uint32_t(size.x)) + 0.5f};
}

// Lattice: of a mesh, and its places in the order in which they are asked.
struct Lattice {
  TriangleLattice between;
  DiffusionPlaces places;

  Lattice(const SkinSurface& surface, double side, std::size_t most)
      : between(*surface.mesh, side, most, surface.shown),
        places(inLocalOrder(between.positions(), between.normals())) {}
};

}  // namespace

struct BlockDiffusion::State {
  State(std::shared_ptr<const SkinSurface> s, const GaussianSum& p, const Progress& progress);

  std::vector<glm::vec4> diffuse(EnteredLight light, const SpreadWeights& weights,
                                 const Progress& progress) const;
  std::vector<glm::vec4> lightOfSamples(const EnteredLight& light) const;
  AreaPoints sample(const Progress& progress);
  void findShown();
  void addTexelsOfSides();
  void choosePlaces();
  // affordablePlaces: at how many places a level may be asked: in a cloud of loose triangles, which is no surface, at few.
  std::size_t affordablePlaces(int level) const;
  // spreads: whether a level is asked at all, at the vertices at least.
  bool spreads(int level, std::size_t affordable) const {
    return diffusion->resolves(level) && surface->mesh->positions.size() <= std::max(affordable, kFewPlaces);
  }
  // readLattice: adds what is between the places of a lattice at all that is shown.
  void readLattice(const Lattice& lattice, const std::vector<glm::vec4>& atPlaces,
                   std::vector<glm::vec4>& light) const;
  // addAsItFalls: adds light that is not spread.
  void addAsItFalls(const EnteredLight& entered, const glm::vec4& weight,
                    std::vector<glm::vec4>& light) const;
  // mapOf: texels as they are shown, their charts' sides fitted.
  std::vector<glm::vec4> mapOf(const std::vector<glm::vec4>& light) const;

  // Asked: where a level is: at the places of a lattice, or at those that are shown themselves, or nowhere.
  struct Asked {
    std::shared_ptr<const Lattice> lattice;
    bool directly = false;

    bool nowhere() const { return !lattice && !directly; }
  };

  std::shared_ptr<const SkinSurface> surface;
  GaussianSum profile;
  std::vector<glm::vec2> sampled;  // where each sample lies in the atlas
  std::optional<PointDiffusion> diffusion;
  ChartSides sides;
  std::vector<std::uint32_t> texels;  // that are shown
  std::vector<SurfacePlace> shown;    // their places, then those of the sides
  DiffusionPlaces shownPlaces;        // the same, where a level is asked there
  std::array<Asked, std::size_t(PointDiffusion::kSmooth)> asked;
};

BlockDiffusion::State::State(std::shared_ptr<const SkinSurface> s, const GaussianSum& p,
                             const Progress& progress)
    : surface(std::move(s)), profile(p), sides(*surface) {
  diffusion.emplace(sample(progress.part(0, 0.2)), p, progress.part(0.2, 0.8));
  findShown();
  choosePlaces();
}

void BlockDiffusion::State::findShown() {
  texels = surface->pointBased ? coveredTexels(surface->maps) : shownTexels(surface->maps);
  addTexelsOfSides();
  std::erase_if(texels, [&](std::uint32_t texel) { return surface->maps.triangle[texel] >= surface->shown; });
  shown.resize(texels.size());
  parallelItems(texels.size(), kPerTask,
                [&](std::size_t i) { shown[i] = placeOfTexel(*surface, texels[i]); });
  for (const ChartSides::Place& p : sides.places()) shown.push_back({p.triangle, p.weights});
}

// Corners of charts that are narrower than a texel own none, but are looked at.
void BlockDiffusion::State::addTexelsOfSides() {
  std::vector<std::uint32_t> looked;
  for (const ChartSides::Place& p : sides.places())
    for (int k = 0; k < 4; ++k)
      if (p.look.shares[k] > 0) looked.push_back(p.look.texels[std::size_t(k)]);
  std::ranges::sort(looked);
  std::vector<std::uint32_t> both;
  std::ranges::set_union(texels, std::ranges::subrange(looked.begin(), std::ranges::unique(looked).begin()),
                         std::back_inserter(both));
  texels = std::move(both);
}

// Wide levels are asked at places as far apart as they allow, and narrow ones, which would need more places than texels
// show, at those that are shown.
void BlockDiffusion::State::choosePlaces() {
  constexpr double kMostSide = 1.1;  // mm: normals turn too far over more
  const Mesh& mesh = *surface->mesh;
  std::shared_ptr<const Lattice> before;
  for (int level = 1; level <= PointDiffusion::kSmooth; ++level) {
    const double sigma = std::sqrt(PointDiffusion::varianceOf(profile, level)),
                 side = std::max(std::min(0.75 * sigma, kMostSide), 2 * double(surface->atlas.texel));
    const std::size_t most = affordablePlaces(level);
    if (!spreads(level, most)) continue;
    Asked& at = asked[std::size_t(level - 1)];
    const std::uint64_t places = TriangleLattice::placesOf(mesh, side, surface->shown);
    at.directly = places > shown.size() && shown.size() <= most;
    if (at.directly) continue;
    const bool same = before && before->places.size() == places;
    at.lattice = same ? before : std::make_shared<const Lattice>(*surface, side, most);
    before = at.lattice;
  }
  const bool anyDirectly = std::ranges::any_of(asked, [](const Asked& at) { return at.directly; });
  if (anyDirectly) shownPlaces = inLocalOrder(mesh, shown);
}

std::size_t BlockDiffusion::State::affordablePlaces(int level) const {
  constexpr double kMostLooks = 4e8;  // at clusters, twice as many as a head needs
  if (!diffusion->resolves(level)) return 0;
  return std::size_t(
      std::min(kMostLooks / std::max(diffusion->meanNeighbours(level), 1.0), double(TriangleLattice::kMost)));
}

AreaPoints BlockDiffusion::State::sample(const Progress& progress) {
  const Mesh& mesh = *surface->mesh;
  const double spacing = affordableSpacing(mesh, PointDiffusion::kBaseSpacing, kMostSamples);
  SurfaceSamples samples = sampleSurface(mesh, spacing, progress);
  sampled.resize(samples.size());
  parallelItems(sampled.size(), kPerTask, [&](std::size_t i) {
    sampled[i] = placeInAtlas(surface->atlas.corners[samples.triangles[i]], samples.weights[i]);
  });
  return {std::move(samples.positions), std::move(samples.normals), std::move(samples.areas)};
}

std::vector<glm::vec4> BlockDiffusion::State::lightOfSamples(const EnteredLight& entered) const {
  std::vector<glm::vec4> light(sampled.size());
  const glm::ivec2 size = surface->maps.size;
  parallelItems(sampled.size(), kPerTask,
                [&](std::size_t i) { light[i] = lightAt(entered, size, sampled[i]); });
  return light;
}

// Levels at the same places are summed there before texels read between them.
std::vector<glm::vec4> BlockDiffusion::State::diffuse(EnteredLight entered, const SpreadWeights& weights,
                                                      const Progress& progress) const {
  const std::vector<glm::vec4> ofSamples = lightOfSamples(entered);
  const auto isLeft = [&](std::size_t i) { return asked[i].nowhere() && weights[i] != glm::vec4(0); };
  const auto numbers = std::views::iota(std::size_t(0), asked.size());
  if (std::ranges::none_of(numbers, isLeft)) entered = {};  // the map will need as much memory
  std::vector<glm::vec4> light(shown.size(), glm::vec4(0)), atPlaces;
  const Lattice* lattice = nullptr;
  const auto readPlaces = [&] {
    if (lattice) readLattice(*lattice, atPlaces, light);
  };
  glm::vec4 asItFalls(0);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (weights[i] == glm::vec4(0)) continue;
    if (asked[i].nowhere()) {
      asItFalls += weights[i];
      continue;
    }
    if (!asked[i].directly && lattice != asked[i].lattice.get()) {
      readPlaces();
      lattice = asked[i].lattice.get();
      atPlaces.assign(lattice->places.size(), glm::vec4(0));
    }
    const int level = int(i) + 1;
    diffusion->addLightAt(
        level, diffusion->gather(level, ofSamples), asked[i].directly ? shownPlaces : lattice->places,
        weights[i], asked[i].directly ? light : atPlaces, progress.part(0.16 * double(i), 0.16 * level));
  }
  readPlaces();
  if (asItFalls != glm::vec4(0)) addAsItFalls(entered, asItFalls, light);
  return mapOf(light);
}

void BlockDiffusion::State::readLattice(const Lattice& lattice, const std::vector<glm::vec4>& atPlaces,
                                        std::vector<glm::vec4>& light) const {
  parallelItems(light.size(), kPerTask, [&](std::size_t i) {
    const auto& [triangle, weights] = shown[i];
    light[i] += lattice.between.value(atPlaces, surface->mesh->triangles[triangle], triangle, weights);
  });
}

void BlockDiffusion::State::addAsItFalls(const EnteredLight& entered, const glm::vec4& weight,
                                         std::vector<glm::vec4>& light) const {
  const glm::ivec2 size = surface->maps.size;
  parallelItems(light.size(), kPerTask, [&](std::size_t i) {
    const auto& [triangle, weights] = shown[i];
    const glm::vec2 place = i < texels.size() ? middleOf(texels[i], size)
                                              : placeInAtlas(surface->atlas.corners[triangle], weights);
    light[i] += weight * lightAt(entered, size, place);
  });
}

std::vector<glm::vec4> BlockDiffusion::State::mapOf(const std::vector<glm::vec4>& light) const {
  std::vector<glm::vec4> map(surface->maps.position.size(), glm::vec4(0));
  parallelItems(texels.size(), kPerTask, [&](std::size_t i) { map[texels[i]] = light[i]; });
  sides.fit(std::span(light).subspan(texels.size()), map);
  return map;
}

BlockDiffusion::BlockDiffusion() = default;
BlockDiffusion::~BlockDiffusion() = default;
BlockDiffusion::BlockDiffusion(BlockDiffusion&&) noexcept = default;
BlockDiffusion& BlockDiffusion::operator=(BlockDiffusion&&) noexcept = default;

std::size_t BlockDiffusion::placesAsked(int level) const {
  if (!state) return 0;
  const State::Asked& at = state->asked[std::size_t(level - 1)];
  return at.directly ? state->shown.size() : at.lattice ? at.lattice->places.size() : 0;
}

std::size_t BlockDiffusion::bytes() const {
  if (!state) return 0;
  const State& s = *state;
  std::size_t bytes = s.diffusion->bytes() + s.sampled.size() * sizeof(glm::vec2) + s.sides.bytes() +
                      s.texels.size() * sizeof(std::uint32_t) + s.shown.size() * sizeof(SurfacePlace) +
                      s.shownPlaces.bytes();
  const Lattice* before = nullptr;
  for (const State::Asked& at : s.asked) {
    if (at.lattice && at.lattice.get() != before) bytes += 2 * at.lattice->places.bytes();
    before = at.lattice.get();
  }
  return bytes;
}

std::vector<glm::vec4> diffuseInBlocks(std::shared_ptr<const SkinSurface> surface, const GaussianSum& profile,
                                       EnteredLight light, const SpreadWeights& weights, BlockDiffusion& kept,
                                       const Progress& progress) {
  const std::size_t texels = surface->maps.position.size();
  require(light.irradiance.size() == texels && (light.thinness.empty() || light.thinness.size() == texels),
          "Every texel of the atlas needs an irradiance.");
  if (!kept.state || kept.state->surface != surface || kept.state->profile.variances != profile.variances)
    kept.state = std::make_unique<BlockDiffusion::State>(std::move(surface), profile, progress.part(0, 0.4));
  return kept.state->diffuse(std::move(light), weights, progress.part(0.4, 1));
}

SpreadWeights levelWeights(int level) {
  SpreadWeights weights{};
  weights[std::size_t(level - 1)] = glm::vec4(1);
  return weights;
}

SpreadWeights sumWeights(const GaussianSum& profile) {
  SpreadWeights weights{};
  for (std::size_t i = 0; i < kLevels; ++i) weights[i] = glm::vec4(profile.weights[i + 1], 0);
  weights[std::size_t(PointDiffusion::smoothLevel(profile) - 1)].a = 1;
  return weights;
}

PointDiffusion::Levels levelsInBlocks(const std::shared_ptr<const SkinSurface>& surface,
                                      const GaussianSum& profile, const EnteredLight& light,
                                      BlockDiffusion& kept, const Progress& progress) {
  PointDiffusion::Levels levels;
  for (int level = 1; level <= kLevels; ++level)
    levels[std::size_t(level - 1)] = diffuseInBlocks(surface, profile, light, levelWeights(level), kept,
                                                     progress.part(0.2 * (level - 1), 0.2 * level));
  return levels;
}

}  // namespace sonoskin
