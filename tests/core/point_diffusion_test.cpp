#include "core/skin/point_diffusion.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/base/parallel.h"
#include "core/skin/brute_force.h"
#include "tests/support/expect_error.h"
#include "tests/support/meshes.h"
#include "tests/support/skin_tables.h"

namespace sonoskin {
namespace {

AreaPoints pointsOf(const SurfaceSamples& samples) {
  return {samples.positions, samples.normals, samples.areas};
}

std::vector<glm::vec4> fourOf(const std::vector<glm::vec3>& irradiance) {
  std::vector<glm::vec4> four;
  for (const glm::vec3& e : irradiance) four.emplace_back(e, 1.f);
  return four;
}

// A surface and its points, and the sum of all six terms at places on it; the first is given.
struct Lit {
  explicit Lit(const Mesh& mesh, double spacing)
      : samples(sampleSurface(mesh, spacing)), diffusion(pointsOf(samples), literatureSkin()) {}

  template <class F>
  std::vector<glm::vec3> at(const std::vector<DiffusionTarget>& targets, F&& irradiance) const {
    std::vector<glm::vec3> positions, normals;
    for (const DiffusionTarget& t : targets) positions.push_back(t.position), normals.push_back(t.normal);
    const auto levels = diffusion.gather(fourOf(test::irradianceOn(samples, irradiance)));
    std::vector<DiffusedLevels> found(targets.size());
    for (std::size_t t = 0; t < targets.size(); ++t) found[t][0] = targets[t].irradiance;
    for (int i = 1; i <= PointDiffusion::kLevels; ++i) {
      const auto light = diffusion.lightAt(i, levels[std::size_t(i - 1)], inLocalOrder(positions, normals));
      for (std::size_t t = 0; t < targets.size(); ++t) found[t][std::size_t(i)] = glm::vec3(light[t]);
    }
    std::vector<glm::vec3> sums;
    for (const DiffusedLevels& l : found) sums.push_back(sumOfLevels(literatureSkin(), l));
    return sums;
  }

  SurfaceSamples samples;
  PointDiffusion diffusion;
};

TEST(PointDiffusion, EvenLightStaysEven) {
  Mesh mesh = test::icosphere(4, 10, glm::vec3(0));
  mesh.triangles.resize(mesh.triangles.size() / 2);  // with borders
  const Lit lit(mesh, 0.3);
  std::vector<DiffusionTarget> targets;
  for (std::size_t i = 0; i < lit.samples.size(); ++i)
    targets.push_back({lit.samples.positions[i], lit.samples.normals[i], glm::vec3(1)});
  const auto lights = lit.at(targets, [](const glm::vec3&, const glm::vec3&) { return 1; });
  ASSERT_EQ(lights.size(), targets.size());
  for (const glm::vec3& light : lights) ASSERT_LT(glm::distance(light, glm::vec3(1)), 3e-6f);
}

TEST(PointDiffusion, SineLosesAmplitude) {
  const Lit lit(test::plane(14, 14, 1), 0.15);
  for (const test::SkinValue& v : test::kSine) {
    const double k = 2 * std::numbers::pi / v.at;
    std::vector<DiffusionTarget> targets;
    for (int i = -20; i <= 20; ++i) targets.push_back({{0, 0.1f * float(i), 0}, {0, 0, 1}, glm::vec3(0)});
    glm::dvec3 mean(0);
    for (const glm::vec3& light :
         lit.at(targets, [&](const glm::vec3&p, const glm::vec3&) { return std::cos(k * double(p.x)); }))
      mean += glm::dvec3(light) / double(targets.size());
    const GaussianSum skin = literatureSkin();
    const glm::dvec3 first = skin.weights[0] * std::exp(-0.5 * k * k * skin.variances[0]);
    const double tolerance = v.at <= 2 ? 0.065 : 0.06 / v.at;  // points 0.3 mm apart
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(mean[c] + first[c], v.light[c], tolerance) << v.at << " colour " << c;
  }
}

TEST(PointDiffusion, HalfPlane) {
  const Lit lit(test::plane(14, 14, 1), 0.15);
  const GaussianSum skin = literatureSkin();
  for (const test::SkinValue& v : test::kHalfPlane) {
    std::vector<DiffusionTarget> targets;
    for (int i = -20; i <= 20; ++i)
      targets.push_back({{float(v.at), 0.1f * float(i), 0},
                         {0, 0, 1},
                         glm::vec3(float(0.5 * std::erfc(-v.at / std::sqrt(2 * skin.variances[0]))))});
    double rms = 0;
    for (const glm::vec3& light :
         lit.at(targets, [&](const glm::vec3&p, const glm::vec3&) { return p.x > 0; }))
      rms += glm::dot(glm::dvec3(light) - v.light, glm::dvec3(light) - v.light) / double(targets.size());
    EXPECT_LT(std::sqrt(rms / 3), std::abs(v.at) < 0.3 ? 0.014 : 0.007) << v.at;
  }
}

TEST(PointDiffusion, TerminatorOfASphere) {
  const Lit lit(test::icosphere(5, 10, glm::vec3(0)), 0.15);
  const auto cosine = [](const glm::vec3&, const glm::vec3& n) { return std::max(0.f, n.z); };
  for (const test::SkinValue& v : test::kSphere10) {
    std::vector<DiffusionTarget> targets;
    for (int i = 0; i < 100; ++i) {
      const double angle = glm::radians(v.at), turn = 0.0628 * i;
      const glm::vec3 n(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle));
      targets.push_back({10.f * n, n, glm::vec3(std::max(0.f, n.z))});
    }
    double worst = 0;
    for (const glm::vec3& light : lit.at(targets, cosine))
      worst = std::max(worst, glm::length(glm::dvec3(light) - v.light));
    EXPECT_LT(worst, v.at == 90 ? 0.005 : 0.002) << v.at;
  }
}

// RMS of red between the points' light and the integral over the surface.
double errorOn(const Mesh& mesh) {
  const Lit lit(mesh, 0.25);
  const auto cosine = [](const glm::vec3&, const glm::vec3& n) { return std::max(0.f, n.x); };
  std::vector<DiffusionTarget> targets;
  for (std::size_t i = 0; i < lit.samples.size(); i += lit.samples.size() / 500)
    targets.push_back(
        {lit.samples.positions[i], lit.samples.normals[i], glm::vec3(cosine({}, lit.samples.normals[i]))});
  const SurfaceSamples fine = sampleSurface(mesh, 0.11);
  const auto exact =
      bruteForceDiffusion(fine, test::irradianceOn(fine, cosine), literatureSkin(), targets, Reach::local);
  const auto found = lit.at(targets, cosine);
  double squares = 0;
  for (std::size_t t = 0; t < targets.size(); ++t)
    squares += std::pow(double(found[t].x - sumOfLevels(literatureSkin(), exact[t]).x), 2);
  return std::sqrt(squares / double(targets.size()));
}

TEST(PointDiffusion, FollowsBruteForce) {
  EXPECT_LT(errorOn(test::icosphere(5, 20, {3, 4, 5})), 2e-4);  // 20,480 triangles, 5,000 mm^2
}

// A lens with an edge as narrow as a lip's: which points face the same way changes from place to place.
TEST(PointDiffusion, FollowsBruteForceAroundNarrowEdges) {
  Mesh lens = test::icosphere(5, 8, glm::vec3(0));
  for (glm::vec3& p : lens.positions) p.x *= 0.3f;
  computeNormals(lens);
  EXPECT_LT(errorOn(lens), 4e-3);
}

// A cluster is what it says: every point in the nearest one that faces its way, at its centre of mass.
TEST(PointClusters, HoldEveryPointAndKeepArea) {
  const SurfaceSamples samples = sampleSurface(test::icosphere(3, 10, glm::vec3(0)), 0.3);
  const AreaPoints points = pointsOf(samples);
  const PointClusters clusters = clusterPoints(points, 1.5);
  std::vector<glm::dvec3> centre(clusters.points.size(), glm::dvec3(0));
  std::vector<double> area(clusters.points.size(), 0);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const std::uint32_t b = clusters.clusterOf[p];
    ASSERT_LT(glm::distance(points.positions[p], clusters.points.positions[b]), 1.7f);
    centre[b] += double(points.areas[p]) * glm::dvec3(points.positions[p]);
    area[b] += double(points.areas[p]);
  }
  for (std::size_t b = 0; b < area.size(); ++b) {
    EXPECT_NEAR(double(clusters.points.areas[b]), area[b], 1e-4);
    EXPECT_LT(glm::distance(glm::dvec3(clusters.points.positions[b]), centre[b] / area[b]), 1e-5);
  }
  const double mean = std::sqrt(4 * std::numbers::pi * 100 / double(area.size()));
  EXPECT_GT(mean, 1.4);
  EXPECT_LT(mean, 1.9);
  EXPECT_NEAR(clusters.variance, mean * mean / 12, 0.3 * mean * mean / 12);
}

TEST(PointClusters, KeepsTheSidesOfASheetApart) {
  AreaPoints points;
  for (const float side : {-1.f, 1.f})
    for (int i = 0; i < 100; ++i) {
      points.positions.emplace_back(0.1f * float(i % 10), 0.1f * float(i / 10), 0.05f * side);
      points.normals.emplace_back(0, 0, side);
      points.areas.push_back(0.01f);
    }
  const PointClusters clusters = clusterPoints(points, 0.5);
  for (std::size_t p = 0; p < points.size(); ++p)
    EXPECT_EQ(clusters.points.normals[clusters.clusterOf[p]], points.normals[p]);
}

TEST(PointDiffusion, DoesNotDependOnThreads) {
  const Mesh mesh = test::icosphere(4, 8, glm::vec3(0));
  const auto run = [&](int threads) {
    setThreadCount(threads);
    const Lit lit(mesh, 0.2);
    const std::vector<DiffusionTarget> targets{{{0, 0, 8}, {0, 0, 1}, glm::vec3(1)},
                                               {{0, 8, 0}, {0, 1, 0}, glm::vec3(0)}};
    auto light = lit.at(targets, [](const glm::vec3& p, const glm::vec3&) { return p.z > 1; });
    setThreadCount(0);
    return light;
  };
  EXPECT_EQ(run(1), run(3));
}

TEST(PointDiffusion, GaussiansNarrowerThanItsPointsAreLeftOut) {
  const AreaPoints points = pointsOf(sampleSurface(test::plane(6, 6, 1), 0.2));
  const PointDiffusion usual(points, literatureSkin());
  for (int i = 1; i <= PointDiffusion::kLevels; ++i) EXPECT_TRUE(usual.resolves(i)) << i;
  const PointDiffusion narrow(points, scaledByWidth(literatureSkin(), 0.3));
  EXPECT_FALSE(narrow.resolves(1));
  EXPECT_TRUE(narrow.resolves(5));
  const PointDiffusion none(points, scaledByWidth(literatureSkin(), 0));
  for (int i = 1; i <= PointDiffusion::kLevels; ++i) EXPECT_FALSE(none.resolves(i)) << i;
}

TEST(DiffusionPlaces, AreAllThereAndNearTheOnesBefore) {
  const Mesh mesh = test::icosphere(5, 10, glm::vec3(0));
  const DiffusionPlaces places = inLocalOrder(mesh.positions, mesh.normals);
  ASSERT_EQ(places.size(), mesh.positions.size());
  std::vector<bool> seen(places.size(), false);
  double way = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_FALSE(seen[places.order[i]]);
    seen[places.order[i]] = true;
    EXPECT_EQ(places.positions[i], mesh.positions[places.order[i]]);
    EXPECT_EQ(places.normals[i], mesh.normals[places.order[i]]);
    if (i > 0) way += double(glm::distance(places.positions[i], places.positions[i - 1]));
  }
  EXPECT_LT(way / double(places.size()), 0.8);  // sides are 0.35 long
  EXPECT_EQ(inLocalOrder({}, {}).size(), 0u);
}

TEST(PointDiffusion, RefusesNonsenseAndCanBeCancelled) {
  test::expectError([] { PointDiffusion(AreaPoints(), literatureSkin()); }, "samples");
  const AreaPoints points = pointsOf(sampleSurface(test::plane(3, 3, 1), 0.3));
  test::expectError([&] { PointDiffusion(points, literatureSkin()).gather({}); }, "irradiance");
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(PointDiffusion(points, literatureSkin(), Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
