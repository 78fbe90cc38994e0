#include "core/skin/reference_diffusion.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel_blocks.h"
#include "core/skin/atlas_reading.h"
#include "core/skin/brute_force.h"
#include "core/skin/hierarchical_integral.h"
#include "core/skin/scatter_profile.h"
#include "core/skin/shown_places.h"

namespace sonoskin {
namespace {

constexpr std::size_t kTexelsPerTask = 64;
constexpr double kSpacing = 0.15;  // mm between samples
constexpr std::size_t kMostSamples = 8'000'000;

// What the narrow part of a profile, which no sample tells from a point, and its wide part are.
struct SplitProfile {
  glm::dvec3 narrow{0};  // share of the light
  RadialProfile wide;
  double spacing = kSpacing;
};

SplitProfile splitProfile(const GaussianSum& profile, const Mesh& mesh) {
  // As far apart as the second Gaussian allows.
  const double spacing =
      affordableSpacing(mesh, std::clamp(0.7 * std::sqrt(profile.variances[1]), 0.1, 0.3), kMostSamples);
  int first = 0;
  glm::dvec3 narrow(0);
  for (; first < GaussianSum::kCount && !isResolved(profile.variances[std::size_t(first)], spacing); ++first)
    narrow += profile.weights[std::size_t(first)];
  return {narrow, profileOf(profile, first), spacing};
}

SplitProfile splitProfile(const MediumRgb& medium, const Mesh& mesh) {
  const std::array<Dipole, 3> d{makeDipole(medium[0]), makeDipole(medium[1]), makeDipole(medium[2])};
  const glm::dvec3 total(totalReflectance(d[0]), totalReflectance(d[1]), totalReflectance(d[2]));
  const auto perArea = [=](double r) {
    return glm::dvec3(diffuseReflectance(d[0], r), diffuseReflectance(d[1], r), diffuseReflectance(d[2], r)) /
           total;
  };
  return {glm::dvec3(0), RadialProfile(perArea, glm::dvec3(1)),
          affordableSpacing(mesh, kSpacing, kMostSamples)};
}

HierarchicalIntegral treeOf(const SkinSurface& surface, const std::vector<glm::vec4>& irradiance,
                            double spacing, const Progress& progress) {
  const SurfaceSamples samples = sampleSurface(*surface.mesh, spacing, progress);
  std::vector<glm::vec3> light;
  light.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Corners& corners = surface.atlas.corners[samples.triangles[i]];
    light.push_back(readAtlas(irradiance, surface.maps.size, placeInAtlas(corners, samples.weights[i])));
  }
  return HierarchicalIntegral(samples, light);
}

std::vector<glm::vec4> integrate(const SkinSurface& surface, const SplitProfile& profile,
                                 const std::vector<glm::vec4>& irradiance, const Progress& progress) {
  const AtlasMaps& maps = surface.maps;
  require(irradiance.size() == maps.position.size(), "Every texel of the atlas needs an irradiance.");
  const HierarchicalIntegral tree = treeOf(surface, irradiance, profile.spacing, progress.part(0, 0.03));
  const std::vector<std::uint32_t> shown = shownTexels(maps);
  std::vector<glm::vec4> result(irradiance.size(), glm::vec4(0));
  parallelItems(
      shown.size(), kTexelsPerTask,
      [&](std::size_t i) {
        const std::uint32_t t = shown[i];
        const glm::vec3 own = irradiance[t].a > 0 ? glm::vec3(irradiance[t]) / irradiance[t].a : glm::vec3(0);
        const glm::vec3 wide =
            tree.at(glm::vec3(maps.position[t]), glm::vec3(maps.normal[t]), profile.wide, {});
        result[t] = glm::vec4(glm::vec3(profile.narrow) * own + wide, 1);
      },
      progress.part(0.05, 1));
  return result;
}

}  // namespace

std::vector<glm::vec4> referenceDiffusion(const SkinSurface& surface, const GaussianSum& profile,
                                          const std::vector<glm::vec4>& irradiance,
                                          const Progress& progress) {
  return integrate(surface, splitProfile(profile, *surface.mesh), irradiance, progress);
}

std::vector<glm::vec4> referenceDiffusion(const SkinSurface& surface, const MediumRgb& medium,
                                          const std::vector<glm::vec4>& irradiance,
                                          const Progress& progress) {
  return integrate(surface, splitProfile(medium, *surface.mesh), irradiance, progress);
}

std::vector<glm::vec4> referenceDiffusion(const SkinSurface& surface, const SkinOptions& skin,
                                          const std::vector<glm::vec4>& irradiance,
                                          const Progress& progress) {
  // The literature's skin has no medium behind its Gaussians, and a width is no property of one.
  const bool gaussians = skin.profile == ScatterProfile::adult || skin.width != 1;
  return gaussians ? referenceDiffusion(surface, diffusionOf(skin), irradiance, progress)
                   : referenceDiffusion(surface, mediumOf(skin), irradiance, progress);
}

}  // namespace sonoskin
