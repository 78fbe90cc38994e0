#include "tests/benchmarks/accuracy/skin.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/skin/brute_force.h"
#include "core/skin/point_diffusion.h"
#include "render/gl/context.h"
#include "tests/benchmarks/accuracy/skin_heads.h"
#include "tests/benchmarks/accuracy/skin_light.h"
#include "tests/benchmarks/accuracy/skin_places.h"

namespace sonoskin::accuracy {
namespace {

constexpr std::size_t kPlaces = 6000;
constexpr float kNearSeam = 3;  // mm

struct NamedLighting {
  std::string name;
  SkinLighting lighting;
};

// The light that meets a surface at its cosine, plain and through a checker of squares of 2 mm.
std::vector<NamedLighting> lightings(const HomeFrame& home) {
  const glm::vec3 l = glm::normalize(0.8f * home.right + 0.3f * home.up + 0.5f * home.back);
  const SkinLighting cosine = [l](const glm::vec3&, const glm::vec3& n) {
    return std::max(0.f, glm::dot(n, l));
  };
  const SkinLighting checker = [cosine, home](const glm::vec3& p, const glm::vec3& n) {
    constexpr float kTurn = 2 * std::numbers::pi_v<float> / 4;
    const bool lit = std::sin(kTurn * glm::dot(p, home.right)) * std::sin(kTurn * glm::dot(p, home.up)) > 0;
    return cosine(p, n) * (lit ? 1.f : 0.1f);
  };
  return {{"cosine", cosine}, {"4 mm checker", checker}};
}

// What is right at some places of a head in one light.
struct SkinTruth {
  std::vector<DiffusionTarget> targets;
  std::vector<glm::vec3> local, full;
};

std::vector<glm::vec3> irradianceOf(const SurfaceSamples& samples, const SkinLighting& lighting) {
  std::vector<glm::vec3> irradiance;
  for (std::size_t i = 0; i < samples.size(); ++i)
    irradiance.emplace_back(lighting(samples.positions[i], samples.normals[i]));
  return irradiance;
}

SkinTruth truthOf(const SurfaceSamples& samples, const SkinPlaces& places, const SkinLighting& lighting) {
  SkinTruth truth;
  truth.targets = targetsOf(places, lighting);
  const std::vector<glm::vec3> irradiance = irradianceOf(samples, lighting);
  const GaussianSum skin = literatureSkin();
  for (const Reach reach : {Reach::local, Reach::full})
    for (const DiffusedLevels& levels : bruteForceDiffusion(samples, irradiance, skin, truth.targets, reach))
      (reach == Reach::local ? truth.local : truth.full).push_back(sumOfLevels(skin, levels));
  return truth;
}

// From point to point without an atlas, at the same places.
std::vector<glm::vec3> byPoints(const Mesh& mesh, const SkinPlaces& places, const SkinTruth& truth,
                                const SkinLighting& lighting) {
  const SurfaceSamples samples = sampleSurface(mesh, PointDiffusion::kBaseSpacing);
  const GaussianSum skin = literatureSkin();
  const PointDiffusion diffusion({samples.positions, samples.normals, samples.areas}, skin);
  std::vector<glm::vec4> irradiance;
  for (const glm::vec3& e : irradianceOf(samples, lighting)) irradiance.emplace_back(e, 1.f);
  const PointDiffusion::Levels levels = diffusion.gather(irradiance);
  std::vector<DiffusedLevels> found;
  for (const DiffusionTarget& t : truth.targets) found.push_back({t.irradiance});
  for (int i = 1; i <= PointDiffusion::kLevels; ++i) {
    const std::vector<glm::vec4> light =
        diffusion.lightAt(i, levels[std::size_t(i - 1)], inLocalOrder(places.positions, places.normals));
    for (std::size_t p = 0; p < light.size(); ++p) found[p][std::size_t(i)] = glm::vec3(light[p]);
  }
  std::vector<glm::vec3> sums;
  for (const DiffusedLevels& l : found) sums.push_back(sumOfLevels(skin, l));
  return sums;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, std::size_t(share * double(values.size())))];
}

void print(const std::string& name, const std::vector<glm::vec3>& found, const std::vector<glm::vec3>& truth,
           const std::vector<bool>& nearSeam = {}, const std::string& jump = "") {
  glm::dvec3 squares(0);
  glm::dvec2 red(0), count(0);  // elsewhere, near a seam
  std::vector<double> errors;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const glm::dvec3 d(found[i] - truth[i]);
    squares += d * d;
    errors.push_back(std::abs(d.x));
    const int side = !nearSeam.empty() && nearSeam[i] ? 1 : 0;
    red[side] += d.x * d.x, count[side] += 1;
  }
  const glm::dvec3 rms = glm::sqrt(squares / double(found.size()));
  const auto part = [&](int side) { return count[side] > 0 ? std::sqrt(red[side] / count[side]) : 0; };
  const std::string near = nearSeam.empty() ? "| |"
                                            : fmt::format("{:.4f} ({:.0f} %) | {:.4f} |", part(1),
                                                          100 * count[1] / double(found.size()), part(0));
  const std::string row =
      fmt::format("| {} | {:.4f} | {:.4f} | {:.4f} | {:.4f} | {:.4f} | {:.3f} | {} {} |", name, rms.x, rms.y,
                  rms.z, quantile(errors, 0.95), quantile(errors, 0.99), quantile(errors, 1), near, jump);
  std::printf("%s\n", row.c_str());
  std::fflush(stdout);
}

// The largest difference of a colour between both sides of the seams: 95th and 99th percentile.
std::string jumps(const LitAtlas& atlas, const Seams& seams) {
  std::vector<double> differences;
  for (const auto& [a, b] : seams.sides) {
    const glm::vec3 d = glm::abs(atlas.at(a, glm::vec3(0)) - atlas.at(b, glm::vec3(0)));
    differences.push_back(double(std::max({d.x, d.y, d.z})));
  }
  if (differences.empty()) return "none";
  return fmt::format("{:.4f}, {:.4f}", quantile(differences, 0.95), quantile(differences, 0.99));
}

// How far even light is from even after it has spread: over the places and both sides of the seams.
void printFurnace(const std::shared_ptr<const SkinSurface>& surface, const SkinPlaces& places) {
  const SkinLighting white = [](const glm::vec3&, const glm::vec3&) { return 1.f; };
  const Seams seams = findSeams(*surface->mesh, surface->atlas);
  std::string text;
  for (const bool byPoints : {false, true}) {
    const LitAtlas atlas = byPoints ? litByPoints(surface, white) : litByPasses(surface, white);
    double worst = 0;
    const auto look = [&](const SkinPlace& place) {
      const glm::vec3 d = glm::abs(atlas.at(place, glm::vec3(1)) - glm::vec3(1));
      worst = std::max(worst, double(std::max({d.x, d.y, d.z})));
    };
    for (const SkinPlace& place : places.places) look(place);
    for (const auto& sides : seams.sides) look(sides[0]), look(sides[1]);
    text += fmt::format("{} {:.5f}", byPoints ? ", points" : "blurs", worst);
  }
  std::printf("%.2f mm, even light, largest difference from 1 over the mesh and its seams: %s\n\n",
              double(surface->atlas.texel), text.c_str());
}

void printHead(const SkinHead& head) {
  const double area = surfaceArea(*head.mesh);
  std::printf("### %s: %zu triangles, %.0f mm²\n\n", head.name.c_str(), head.mesh->triangles.size(), area);
  const SkinPlaces places = spreadPlaces(*head.mesh, kPlaces);
  const SurfaceSamples samples = sampleSurface(*head.mesh, area > 50000 ? 0.15 : 0.11);
  std::vector<std::shared_ptr<const SkinSurface>> surfaces;
  for (SkinQuality quality : {fullQuality(), lightQuality()}) {
    quality.triangles = 0;
    surfaces.push_back(prepareSkin(head.mesh, head.home.back, quality));
    const SkinSurface& s = *surfaces.back();
    const AtlasCheck check = checkAtlas(*s.mesh, s.atlas);
    std::printf(
        "%.2f mm: %s, %dx%d texels of %.3f mm, %d charts, seams %.2f m, overlap %.2f %%, uncovered %.2f %%, "
        "stretch %.2f (99 %%)\n\n",
        quality.texel, s.pointBased ? "in blocks" : "atlas", s.atlas.size.x, s.atlas.size.y,
        double(s.atlas.texel), check.charts, 1e-3 * check.seamLength, 100 * check.overlap,
        100 * check.uncovered, check.stretch99);
    printFurnace(surfaces.back(), places);
  }
  std::printf(
      "| | RMS R | G | B | p95 R | p99 R | max R | near seam R | else R | jump p95, p99 |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n");
  for (const NamedLighting& light : lightings(head.home)) {
    const SkinTruth truth = truthOf(samples, places, light.lighting);
    for (const auto& surface : surfaces)
      for (const bool byPoints : {false, true}) {
        const std::string method = byPoints ? "points in the atlas" : "blurs in the atlas";
        const LitAtlas atlas =
            byPoints ? litByPoints(surface, light.lighting) : litByPasses(surface, light.lighting);
        std::vector<glm::vec3> found;
        for (std::size_t i = 0; i < kPlaces; ++i)
          found.push_back(atlas.at(places.places[i], truth.targets[i].irradiance));
        const Seams seams = findSeams(*surface->mesh, surface->atlas);
        print(fmt::format("{}, {}, {:.2f} mm", light.name, method, double(surface->atlas.texel)), found,
              truth.local, nearSeams(places.positions, seams, kNearSeam), jumps(atlas, seams));
      }
    std::vector<glm::vec3> unspread;
    for (const DiffusionTarget& t : truth.targets) unspread.push_back(t.irradiance);
    print(light.name + ", points alone", byPoints(*head.mesh, places, truth, light.lighting), truth.local);
    print(light.name + ", not spread", unspread, truth.local);
    print(light.name + ", through thin parts", truth.full, truth.local);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

void printSkinTables(const Parameters& parameters) {
  const auto context = gl::makeOffscreenContext();
  std::printf("## Skin: light against the integral over the surface\n\n%s\n\n", gl::glInfo().c_str());
  for (const SkinHead& head : skinHeads(parameters))
    if (head.mesh)
      printHead(head);
    else
      std::printf("### %s\n\nNot measured: its file is missing.\n\n", head.name.c_str());
}

}  // namespace sonoskin::accuracy
