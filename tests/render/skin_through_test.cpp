// Light that comes through thin parts: plates show what their thickness lets through; nothing else glows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/skin/skin_material.h"
#include "render/gl/read_pixels.h"
#include "render/skin/light_passes.h"
#include "render/skin/skin_view.h"
#include "tests/render/support/gl_test.h"
#include "tests/support/skin_tables.h"

namespace sonoskin {
namespace {

SkinOptions plainSkin(double translucency) {
  SkinOptions skin;
  skin.colour = SkinColour::plain;
  skin.mix = skin.gloss = skin.wetness = skin.detail = skin.vernix = 0;
  skin.translucency = translucency;
  return skin;
}

// Every side has normals of its own: sharp edges.
Mesh withSharpEdges(const Mesh& mesh) {
  Mesh sharp;
  for (const Triangle& t : mesh.triangles) {
    const auto first = std::uint32_t(sharp.positions.size());
    const glm::vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    for (const glm::vec3& p : {a, b, c}) {
      sharp.positions.push_back(p);
      sharp.normals.push_back(glm::normalize(glm::cross(b - a, c - a)));
    }
    sharp.triangles.push_back({first, first + 1, first + 2});
  }
  return sharp;
}

// Boxes from z = low to z = high each.
Mesh plates(std::initializer_list<glm::vec2> heights, float half) {
  Mesh mesh;
  for (const glm::vec2& h : heights) {
    const auto first = std::uint32_t(mesh.positions.size());
    for (int corner = 0; corner < 8; ++corner)
      mesh.positions.emplace_back(corner & 1 ? half : -half, corner & 2 ? half : -half,
                                  corner & 4 ? h.y : h.x);
    const std::uint32_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& f : faces) {
      mesh.triangles.push_back({first + f[0], first + f[1], first + f[2]});
      mesh.triangles.push_back({first + f[0], first + f[2], first + f[3]});
    }
  }
  return withSharpEdges(mesh);
}

// A roof whose ridge lies along y at z = 0, its sides at right angles, closed below.
Mesh roof(float side) {
  Mesh mesh;
  const float h = side;
  for (const float y : {-h, h})
    for (const glm::vec2& corner : {glm::vec2(0, 0), glm::vec2(h, -h), glm::vec2(-h, -h)})
      mesh.positions.emplace_back(corner.x, y, corner.y);
  mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {0, 3, 5}, {0, 5, 2}, {1, 2, 5}, {1, 5, 4}, {0, 2, 1}, {3, 4, 5}};
  return withSharpEdges(mesh);
}

class SkinThroughTest : public GlTest {
 protected:
  SkinThroughTest() { context().makeCurrent(); }

  static SkinQuality quality() {
    SkinQuality quality;
    quality.texel = 0.3;
    return quality;
  }
  std::vector<glm::vec4> diffused(double translucency, const glm::vec3& toLight) {
    LightRig rig;
    rig.lights.push_back({.position = glm::normalize(toLight), .colour = glm::vec3(1)});
    view_.relight(gpu_, {plainSkin(translucency), {}, rig}, quality());
    const auto values = gl::readFloats(view_.light().diffuser().result().map, 4);
    std::vector<glm::vec4> texels;
    for (std::size_t i = 0; i < values.size(); i += 4)
      texels.emplace_back(values[i], values[i + 1], values[i + 2], values[i + 3]);
    return texels;
  }
  // What comes through at every texel of the surface where `wanted`: a function of its place and normal.
  template <class F>
  std::vector<glm::dvec3> through(const Mesh& mesh, const glm::vec3& toLight, F&& wanted) {
    const auto surface = prepareSkin(std::make_shared<const Mesh>(mesh), {0, 0, 1}, quality());
    gpu_.set(surface);
    const auto with = diffused(1, toLight), without = diffused(0, toLight);
    std::vector<glm::dvec3> found;
    for (std::size_t t = 0; t < with.size(); ++t)
      if (surface->maps.position[t].w > 0.9f &&
          wanted(glm::vec3(surface->maps.position[t]), glm::vec3(surface->maps.normal[t])))
        found.emplace_back(glm::dvec3(with[t]) - glm::dvec3(without[t]));
    EXPECT_FALSE(found.empty()) << "the place is not in the atlas";
    return found;
  }
  // Toward +z in the middle of the plates' upper sides at height z, from a light below.
  glm::dvec3 throughPlate(const Mesh& mesh, float z) {
    const auto found = through(mesh, {0, 0, -1}, [&](const glm::vec3& p, const glm::vec3& n) {
      return std::abs(p.x) < 0.3f && std::abs(p.y) < 0.3f && std::abs(p.z - z) < 0.01f && n.z > 0.9f;
    });
    return found.empty() ? glm::dvec3(0) : found.front();
  }

  GpuSkin gpu_;
  SkinView view_;
};

// A plate that is lit from behind shows the transmittance of its thickness.                      [theory/skin.md, 7.3]
TEST_F(SkinThroughTest, APlateShowsItsTransmittance) {
  const SkinMaterial material = makeSkinMaterial(plainSkin(1));
  for (const float thickness : {4.f, 6.f, 10.f}) {
    const glm::dvec3 found = throughPlate(plates({{0, thickness}}, 15), thickness);
    const double place = double(thickness) / SkinMaterial::kReach * (SkinMaterial::kSteps - 1);
    const auto step = std::size_t(place);
    const glm::dvec3 expected(glm::mix(material.transmittance[step], material.transmittance[step + 1],
                                       float(place - double(step))));
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(found[c], expected[c], 0.03 * expected[c] + 0.002) << thickness << " " << c;
  }
}

TEST_F(SkinThroughTest, NothingComesThroughAir) {
  EXPECT_LT(throughPlate(plates({{0, 2}, {8, 10}}, 15), 10).r, 0.01);
}

// Two sheets that lie nearly on each other are one skin, found twice: no thinner than a thick body.
TEST_F(SkinThroughTest, SheetsOfOneSkinDoNotGlow) {
  EXPECT_LT(throughPlate(plates({{0, 0.3f}}, 15), 0.3f).r, throughPlate(plates({{0, 30}}, 15), 30).r + 0.002);
  // A wing of a nose still does.
  EXPECT_GT(throughPlate(plates({{0, 2.5f}}, 15), 2.5f).r, 0.15);
}

// On the dark side of a ridge there is no ember along it; some red comes from farther away, as on the wing of a nose.
TEST_F(SkinThroughTest, AFoldDoesNotGlow) {
  const auto most = [&](float from, float to) {
    double red = 0;
    for (const glm::dvec3& light :
         through(roof(20), {-0.95f, 0, -0.3f}, [=](const glm::vec3&p, const glm::vec3&n) {
           return n.x > 0.5f && n.z > 0.5f && p.x > from && p.x < to && std::abs(p.y) < 10;
         }))
      red = std::max(red, light.r);
    return red;
  };
  EXPECT_LT(most(0.2f, 0.8f), 0.01);
  EXPECT_LT(most(0.8f, 8), 0.15);
}

// The light at the back stands in every look: it does not come through what is thin, for scans leave bodies open there.
TEST_F(SkinThroughTest, OnlyTheMovableLightComesThrough) {
  const auto surface = prepareSkin(std::make_shared<const Mesh>(plates({{0, 4}}, 15)), {0, 0, 1}, quality());
  gpu_.set(surface);
  LightRig rig;
  const SkinLight dark{.colour = glm::vec3(0), .shadows = false}, behind{.position = {0, 0, -1}};
  for (const int number : {0, 2}) {
    rig.lights.assign(3, dark);
    rig.lights[std::size_t(number)] = behind;
    view_.relight(gpu_, {plainSkin(1), {}, rig}, quality());
    const auto values = gl::readFloats(view_.light().diffuser().result().map, 4);
    double most = 0;
    for (std::size_t t = 0; t < surface->maps.position.size(); ++t)
      if (surface->maps.position[t].w > 0.9f && surface->maps.normal[t].z > 0.9f &&
          glm::length(glm::vec2(surface->maps.position[t])) < 5)
        most = std::max(most, double(values[4 * t]));
    EXPECT_GT(most, number == 0 ? 0.2 : -1) << number;
    EXPECT_LT(most, number == 0 ? 0.7 : 0.01) << number;
  }
}

}  // namespace
}  // namespace sonoskin
