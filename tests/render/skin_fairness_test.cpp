// What pictures of skin promise to people: no half of a face is black, size does not matter, borders are smooth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "core/skin/skin_presets.h"
#include "render/gl/read_pixels.h"
#include "render/mesh_view.h"
#include "render/skin/skin_view.h"
#include "tests/render/support/gl_test.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

// About a face: higher than wide, with a nose and hollows beside it.
Mesh faceLike(float scale) {
  Mesh mesh = test::icosphere(5, 1, {0, 0, 0});
  for (glm::vec3& p : mesh.positions) {
    const glm::vec3 d = p;
    const auto bump = [&](float x, float y, float wide) {
      return std::exp(-((d.x - x) * (d.x - x) + (d.y - y) * (d.y - y)) / (wide * wide));
    };
    const float front = glm::smoothstep(0.f, 0.5f, d.z);
    p = scale * (d * glm::vec3(38, 50, 42) +
                 front * glm::vec3(0, 0,
                                   9 * bump(0, -0.05f, 0.18f) - 5 * bump(-0.35f, 0.2f, 0.2f) -
                                       5 * bump(0.35f, 0.2f, 0.2f)));
  }
  mesh.normals.clear();
  computeNormals(mesh);
  return mesh;
}

// A square in the plane z = 0 that faces +z, turned by `angle`.
Mesh turnedSquare(float half, float angle) {
  Mesh mesh;
  const float c = std::cos(angle), s = std::sin(angle);
  for (const glm::vec2& at : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)})
    mesh.positions.emplace_back(half * (c * at.x - s * at.y), half * (s * at.x + c * at.y), 0);
  mesh.normals.assign(4, {0, 0, 1});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

double luma(const Image& image, int x, int y) {
  const std::uint8_t* p = &image.rgba[std::size_t(4 * (y * image.width + x))];
  return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
}

class SkinFairnessTest : public GlTest {
 protected:
  SkinFairnessTest() { context().makeCurrent(); }

  Image draw(const Mesh& mesh, const char* look, const glm::vec3& forward = {0, 0, -1}) {
    SkinOptions skin;
    LightOptions light;
    applySkinPreset(findSkinPreset(look), skin, light);
    return draw(mesh, skin, light, forward);
  }
  Image draw(const Mesh& mesh, const SkinOptions& skin, const LightOptions& light,
             const glm::vec3& forward = {0, 0, -1}) {
    const SkinQuality quality = lightQuality();
    GpuSkin gpu;
    gpu.set(prepareSkin(std::make_shared<const Mesh>(mesh), {0, 0, 1}, quality));
    const Camera camera = lookAlong(forward, {0, 1, 0}, gpu.box(), 1);
    const HomeFrame home = homeFrame(lookAlong({0, 0, -1}, {0, 1, 0}, gpu.box(), 1));
    const gl::Framebuffer picture({.size = {200, 200}});
    SkinView view;
    view.draw({.surface = gpu,
               .camera = camera,
               .look = {skin, {}, makeLightRig(light, home, gpu.box())},
               .quality = quality,
               .supersampling = 2},
              picture);
    return gl::readImage(picture);
  }
};

TEST_F(SkinFairnessTest, NoHalfOfAFaceIsBlack) {
  const Mesh face = faceLike(1);
  for (const char* look : {"newborn", "live", "clinic"}) {
    const Image image = draw(face, look);
    double half[2] = {0, 0}, darkest = 255;
    int count = 0;
    for (int y = 40; y < 160; ++y)
      for (int x = 60; x < 100; ++x, ++count) {
        half[0] += luma(image, x, y);
        half[1] += luma(image, 199 - x, y);
        darkest = std::min({darkest, luma(image, x, y), luma(image, 199 - x, y)});
      }
    EXPECT_GT(std::min(half[0], half[1]) / count, 80) << look;
    EXPECT_GT(std::min(half[0], half[1]), 0.5 * std::max(half[0], half[1])) << look;
    EXPECT_GT(darkest, 35) << look;
  }
}

// What is in shadow is skin in less light: redder than what is lit, for light between folds has met skin before; neither
// grey nor dark as bruises are.
TEST_F(SkinFairnessTest, ShadowsAreNoBruises) {
  const Image image = draw(faceLike(1), "newborn");
  std::vector<glm::dvec4> shades;  // luma first
  for (int y = 40; y < 160; ++y)
    for (int x = 60; x < 140; ++x) {
      const std::uint8_t* p = &image.rgba[std::size_t(4 * (y * image.width + x))];
      shades.emplace_back(luma(image, x, y), p[0], p[1], p[2]);
    }
  std::sort(shades.begin(), shades.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  const std::size_t tenth = shades.size() / 10;
  glm::dvec4 shadow(0), lit(0);
  for (std::size_t i = 0; i < tenth; ++i) shadow += shades[i], lit += shades[shades.size() - 1 - i];
  EXPECT_GT(shadow.x, 0.55 * lit.x);
  EXPECT_GT((shadow.y - shadow.w) / shadow.x, 1.1 * (lit.y - lit.w) / lit.x) << "red over blue";
}

// A surface that is twice or half as large looks the same, but for what light does over millimetres.
TEST_F(SkinFairnessTest, SizeDoesNotMatter) {
  SkinOptions skin;
  LightOptions light;
  applySkinPreset(findSkinPreset("clay"), skin, light);
  for (const LightKind kind : {LightKind::far, LightKind::near}) {
    light.kind = kind;
    const Image usual = draw(faceLike(1), skin, light);
    for (const float scale : {0.5f, 2.f, 4.f}) {
      const Image other = draw(faceLike(scale), skin, light);
      double sum = 0;
      for (std::size_t i = 0; i < usual.rgba.size(); ++i)
        sum += std::abs(double(usual.rgba[i]) - double(other.rgba[i]));
      EXPECT_LT(sum / double(usual.rgba.size()), 0.6) << scale << " " << int(kind);
    }
  }
}

// How many shades there are between a surface and what is behind it, along an oblique border.
std::size_t shadesOfBorder(const Image& image) {
  const double inside = luma(image, 100, 100), outside = luma(image, 2, 100);
  std::set<int> shades;
  for (int y = 70; y < 130; ++y)
    for (int x = 0; x < 100; ++x) {
      const double share = (luma(image, x, y) - outside) / (inside - outside);
      if (share > 0.06 && share < 0.94) shades.insert(int(std::lround(24 * share)));
    }
  return shades.size();
}

TEST_F(SkinFairnessTest, BordersHaveManyShades) {
  const Mesh square = turnedSquare(20, 0.2f);
  EXPECT_GE(shadesOfBorder(draw(square, "clay")), 8u);
  GpuMesh gpu;
  gpu.set(std::make_shared<const Mesh>(square));
  const Camera camera = lookAlong({0, 0, -1}, {0, 1, 0}, gpu.box(), 1);
  const gl::Framebuffer picture({.size = {200, 200}});
  MeshView view;
  view.draw({.mesh = gpu, .camera = camera, .lighting = portraitLighting(camera), .supersampling = 2},
            picture);
  EXPECT_GE(shadesOfBorder(gl::readImage(picture)), 8u);
}

// The inner side of an open surface: dark flesh, whatever light falls on the other side.
TEST_F(SkinFairnessTest, InnerSidesAreCalm) {
  Mesh bowl = faceLike(1);
  std::erase_if(bowl.triangles, [&](const Triangle& t) {
    return bowl.positions[t[0]].z < 0 || bowl.positions[t[1]].z < 0 || bowl.positions[t[2]].z < 0;
  });
  SkinOptions skin;
  LightOptions light;
  applySkinPreset(findSkinPreset("newborn"), skin, light);
  light.azimuth = -80;  // from the side: half of the outer side is dark
  light.fill = light.surround = 0.1;
  const Image image = draw(bowl, skin, light, {0, 0, 1});
  double least = 255, most = 0;
  for (int y = 60; y < 140; ++y)
    for (int x = 70; x < 130; ++x) {
      least = std::min(least, luma(image, x, y));
      most = std::max(most, luma(image, x, y));
    }
  EXPECT_GT(least, 35);
  EXPECT_LT(most, 2 * least);
}

}  // namespace
}  // namespace sonoskin
