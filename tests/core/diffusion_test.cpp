#include "core/enhancement/diffusion.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

EnhancementOptions steps(int iterations, double conductance = 2) {
  return {EnhancementMethod::diffusion, iterations, conductance};
}

double meanOf(const Volume<float>& v) {
  return std::accumulate(v.data.begin(), v.data.end(), 0.0) / double(v.data.size());
}

Volume<float> noisy(const Geometry& g) {
  std::uint64_t n = 0;
  return test::fill(g, [&](glm::dvec3) { return 0.2 + 0.6 * test::noise(n++); });
}

TEST(Diffusion, KeepsConstants) {
  for (const float value : {0.0f, 0.4f}) {
    const Volume<float> v(test::grid({9, 8, 7}, {1, 1, 2}), value);
    EXPECT_EQ(diffuse(v, steps(5)).data, v.data);
  }
}

TEST(Diffusion, KeepsTheMeanAndTheBounds) {
  const Volume<float> v = noisy(test::grid({20, 18, 16}, {1, 1, 3})), out = diffuse(v, steps(10, 20));
  EXPECT_NEAR(meanOf(out), meanOf(v), 1e-6);
  const auto [low, high] = std::minmax_element(v.data.begin(), v.data.end());
  for (const float value : out.data) {
    EXPECT_GE(value, *low);
    EXPECT_LE(value, *high);
  }
}

TEST(Diffusion, CalmsSpeckleAndKeepsTheEdge) {
  std::uint64_t n = 0;
  const Geometry g = test::grid({40, 24, 24});
  const auto v =
      test::fill(g, [&](glm::dvec3 p) { return (p.x < 20 ? 0.2 : 0.8) + 0.1 * (test::noise(n++) - 0.5); });
  const Volume<float> out = diffuse(v, steps(5));
  const auto statistics = [&](const Volume<float>& u, int from, int to) {
    double sum = 0, squares = 0, count = 0;
    for (int k = 0; k < 24; ++k)
      for (int j = 0; j < 24; ++j)
        for (int i = from; i < to; ++i) {
          const double value = double(u.at(i, j, k));
          sum += value, squares += value * value, count += 1;
        }
    return std::array{sum / count, std::sqrt(squares / count - sum * sum / count / count)};
  };
  EXPECT_LT(statistics(out, 2, 17)[1], 0.4 * statistics(v, 2, 17)[1]) << "speckle";
  EXPECT_LT(statistics(out, 23, 38)[1], 0.4 * statistics(v, 23, 38)[1]) << "speckle";
  EXPECT_GT(statistics(out, 20, 21)[0] - statistics(out, 19, 20)[0], 0.55) << "the step of 0.6 at the edge";
}

// The equation of the header, voxel by voxel in double precision, without slabs.
Volume<float> bruteForceStep(const Volume<float>& v, double edge) {
  const Geometry& g = v.geometry;
  const glm::dvec3 scale(g.axisScale());
  const auto value = [&](const Volume<double>& of, glm::ivec3 p) {
    p = glm::clamp(p, glm::ivec3(0), g.dims - 1);
    return of.at(p.x, p.y, p.z);
  };
  Volume<double> u(g), c(g);
  std::copy(v.data.begin(), v.data.end(), u.data.begin());
  Volume<float> out(g);
  for (const bool flow : {false, true})
    for (int k = 0; k < g.dims.z; ++k)
      for (int j = 0; j < g.dims.y; ++j)
        for (int i = 0; i < g.dims.x; ++i) {
          const glm::ivec3 p(i, j, k);
          double squares = 0, inflow = 0;
          for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 e(0);
            e[axis] = 1;
            const double slope = 0.5 * scale[axis] * (value(u, p + e) - value(u, p - e));
            squares += slope * slope;
            for (const glm::ivec3 q : {p + e, p - e})
              inflow +=
                  scale[axis] * scale[axis] * 0.5 * (value(c, p) + value(c, q)) * (value(u, q) - value(u, p));
          }
          if (!flow) c.at(i, j, k) = 1 / (1 + squares / (edge * edge));
          if (flow) out.at(i, j, k) = float(u.at(i, j, k) + 0.45 / glm::dot(scale, scale) * inflow);
        }
  return out;
}

double medianGradient(const Volume<float>& v) {
  const Geometry& g = v.geometry;
  std::vector<double> gradients;
  for (int k = 1; k < g.dims.z - 1; ++k)
    for (int j = 1; j < g.dims.y - 1; ++j)
      for (int i = 1; i < g.dims.x - 1; ++i)
        gradients.push_back(glm::length(0.5 * glm::dvec3(g.axisScale()) *
                                        glm::dvec3(v.at(i + 1, j, k) - v.at(i - 1, j, k),
                                                   v.at(i, j + 1, k) - v.at(i, j - 1, k),
                                                   v.at(i, j, k + 1) - v.at(i, j, k - 1))));
  std::nth_element(gradients.begin(), gradients.begin() + std::ptrdiff_t(gradients.size() / 2),
                   gradients.end());
  return gradients[gradients.size() / 2];
}

TEST(Diffusion, AgreesWithItsEquation) {
  for (const glm::ivec3 dims : {glm::ivec3(11, 9, 21), glm::ivec3(8, 8, 8)}) {
    const Volume<float> v = noisy(test::grid(dims, {1, 1.5, 3}));
    Volume<float> expected = v;
    for (int n = 0; n < 3; ++n) expected = bruteForceStep(expected, 1.5 * medianGradient(expected));
    const Volume<float> out = diffuse(v, steps(3, 1.5));
    for (std::size_t i = 0; i < v.data.size(); ++i) ASSERT_NEAR(out.data[i], expected.data[i], 2e-6) << i;
  }
}

TEST(Diffusion, DoesNotDependOnTheScaleOfTheVoxels) {
  Volume<float> v = noisy(test::grid({12, 12, 12}, {1, 1, 2}));
  const Volume<float> coarse = diffuse(v, steps(2));
  v.geometry.spacing *= 0.37;
  const Volume<float> fine = diffuse(v, steps(2));
  for (std::size_t i = 0; i < v.data.size(); ++i) ASSERT_NEAR(fine.data[i], coarse.data[i], 1e-6);
}

TEST(Diffusion, TakesAnyShape) {
  for (const glm::ivec3 dims :
       {glm::ivec3(1, 1, 1), glm::ivec3(1, 5, 2), glm::ivec3(7, 1, 1), glm::ivec3(3, 3, 3)})
    EXPECT_NEAR(meanOf(diffuse(noisy(test::grid(dims)), steps(2))), meanOf(noisy(test::grid(dims))), 1e-6);
}

TEST(Diffusion, IsTheSameOnAnyNumberOfThreads) {
  const Volume<float> v = noisy(test::grid({20, 18, 40}));
  setThreadCount(1);
  const Volume<float> one = diffuse(v, steps(3));
  setThreadCount(3);
  const Volume<float> three = diffuse(v, steps(3));
  setThreadCount(0);
  EXPECT_EQ(one.data, three.data);
}

TEST(Diffusion, StopsWhenCancelledAndReportsRisingProgress) {
  const Volume<float> v = noisy(test::grid({32, 32, 32}));
  double last = 0;
  ProgressSink sink;
  sink.report = [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    if (fraction > 0.3) sink.cancel = true;
  };
  EXPECT_THROW(diffuse(v, steps(10), Progress(sink)), Cancelled);
  EXPECT_LT(last, 0.9);
}

}  // namespace
}  // namespace sonoskin
