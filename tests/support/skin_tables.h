#pragma once

#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "core/mesh/mesh.h"

// What light below the skin must do where it is known in closed form, for the six Gaussians of the literature.
namespace sonoskin::test {

struct SkinValue {
  double at;
  glm::dvec3 light;
};

// Light at x mm from the edge of the lit half of a plane.
inline constexpr std::array<SkinValue, 11> kHalfPlane{{{-4, {0.006346, 0.000009, 0}},
                                                       {-2, {0.046455, 0.000341, 0.000028}},
                                                       {-1, {0.125084, 0.003657, 0.000646}},
                                                       {-0.5, {0.207122, 0.031601, 0.005737}},
                                                       {-0.1, {0.362570, 0.243088, 0.183400}},
                                                       {0, {0.5, 0.5, 0.5}},
                                                       {0.1, {0.637430, 0.756912, 0.816600}},
                                                       {0.5, {0.792878, 0.968399, 0.994263}},
                                                       {1, {0.874916, 0.996343, 0.999354}},
                                                       {2, {0.953545, 0.999659, 0.999972}},
                                                       {4, {0.993654, 0.999991, 1}}}};

// Amplitude that is left of a sine of a period in mm.
inline constexpr std::array<SkinValue, 5> kSine{{{1, {0.246760, 0.535189, 0.704304}},
                                                 {2, {0.358308, 0.784579, 0.900162}},
                                                 {5, {0.576710, 0.952235, 0.981304}},
                                                 {10, {0.806286, 0.987015, 0.995169}},
                                                 {20, {0.938112, 0.996669, 0.998781}}}};

// Light in the middle of a lit disk of a radius in mm.
inline constexpr std::array<SkinValue, 4> kDisk{{{0.5, {0.428425, 0.863760, 0.968388}},
                                                 {1, {0.593700, 0.980320, 0.997091}},
                                                 {2, {0.806087, 0.998326, 0.999794}},
                                                 {5, {0.984893, 0.999993, 1}}}};

// Light on a sphere of 10 mm at an angle from the direction of the far light that shines on it.
inline constexpr std::array<SkinValue, 10> kSphere10{{{0, {0.986171, 0.999319, 0.999752}},
                                                      {60, {0.493367, 0.499659, 0.499876}},
                                                      {80, {0.177375, 0.173562, 0.173607}},
                                                      {85, {0.100270, 0.087291, 0.087167}},
                                                      {88, {0.058351, 0.036342, 0.035183}},
                                                      {90, {0.035268, 0.008247, 0.005300}},
                                                      {92, {0.023934, 0.001467, 0.000292}},
                                                      {95, {0.014320, 0.000195, 0.000032}},
                                                      {100, {0.006128, 0.000032, 0.000002}},
                                                      {110, {0.001230, 0.000001, 0}}}};
inline constexpr std::array<SkinValue, 6> kSphere20{{{0, {0.996543, 0.999830, 0.999938}},
                                                     {80, {0.173618, 0.173619, 0.173637}},
                                                     {88, {0.043283, 0.035072, 0.034923}},
                                                     {90, {0.017785, 0.004126, 0.002650}},
                                                     {95, {0.003016, 0.000016, 0.000001}},
                                                     {110, {0.000019, 0, 0}}}};

// plane: a rectangle in z = 0 around the origin in squares of `step` mm, facing +z; x = 0 is an edge of squares.
inline Mesh plane(int halfColumns, int halfRows, float step) {
  Mesh mesh;
  const auto columns = std::uint32_t(2 * halfColumns + 1);
  for (int j = -halfRows; j <= halfRows; ++j)
    for (int i = -halfColumns; i <= halfColumns; ++i) {
      mesh.positions.emplace_back(float(i) * step, float(j) * step, 0.f);
      mesh.normals.emplace_back(0.f, 0.f, 1.f);
    }
  for (std::uint32_t j = 0; j + 1 < std::uint32_t(2 * halfRows + 1); ++j)
    for (std::uint32_t i = 0; i + 1 < columns; ++i) {
      const std::uint32_t a = j * columns + i, b = a + 1, c = b + columns, d = a + columns;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  return mesh;
}

// irradianceOn: E of a function of place and normal, the same in all three colours.
template <class Samples, class F>
std::vector<glm::vec3> irradianceOn(const Samples& samples, F&& f) {
  std::vector<glm::vec3> irradiance;
  irradiance.reserve(samples.positions.size());
  for (std::size_t i = 0; i < samples.positions.size(); ++i)
    irradiance.push_back(glm::vec3(float(f(samples.positions[i], samples.normals[i]))));
  return irradiance;
}

}  // namespace sonoskin::test
