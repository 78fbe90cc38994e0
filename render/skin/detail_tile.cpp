#include "render/skin/detail_tile.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

constexpr int kSide = DetailTile::kSide;
constexpr int kCells = 10;                                 // pores along a side: 0.4 mm each
constexpr float kPoreDepth = 0.012f, kLineDepth = 0.007f;  // mm

float random(int x, int y, int z, std::uint32_t salt) {
  std::uint32_t h =
      std::uint32_t(x) * 0x8da6b343u ^ std::uint32_t(y) * 0xd8163841u ^ std::uint32_t(z) * 0xcb1ab31fu ^ salt;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  return float(h ^ (h >> 15)) / 4294967296.0f;
}

int wrapped(int i, int n) { return (i % n + n) % n; }

// Distance to the nearest of one random point per cell, in cells.                                        [Worley 1996]
float nearestPoint(const glm::vec3& p) {
  const glm::ivec3 cell(glm::floor(p));
  float best = 4;
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const glm::ivec3 c = cell + glm::ivec3(dx, dy, dz);
        const int x = wrapped(c.x, kCells), y = wrapped(c.y, kCells), z = wrapped(c.z, kCells);
        const glm::vec3 at =
            glm::vec3(c) + glm::vec3(random(x, y, z, 1), random(x, y, z, 2), random(x, y, z, 3));
        best = std::min(best, glm::distance(at, p));
      }
  return best;
}

// Smooth noise that repeats after `period` cells.
float noise(const glm::vec3& p, int period, std::uint32_t salt) {
  const glm::ivec3 cell(glm::floor(p));
  glm::vec3 t = p - glm::vec3(cell);
  t = t * t * (3.f - 2.f * t);
  float sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 o(corner & 1, (corner >> 1) & 1, corner >> 2);
    const float w = (o.x ? t.x : 1 - t.x) * (o.y ? t.y : 1 - t.y) * (o.z ? t.z : 1 - t.z);
    const glm::ivec3 c = cell + o;
    sum += w * (2 * random(wrapped(c.x, period), wrapped(c.y, period), wrapped(c.z, period), salt) - 1);
  }
  return sum;
}

// Where noise crosses zero there is a line.
float ridge(const glm::vec3& p, int period, std::uint32_t salt) {
  return std::exp(-18 * std::pow(noise(p * float(period), period, salt), 2.f));
}

float height(const glm::vec3& unit) {
  const float pore = nearestPoint(unit * float(kCells));
  const float dimple = std::exp(-6 * pore * pore) * (0.6f + 0.4f * noise(unit * 5.f, 5, 9));
  return -kPoreDepth * dimple - kLineDepth * std::max(ridge(unit, 8, 11), ridge(unit, 9, 12));
}

}  // namespace

DetailTile makeDetailTile() {
  std::vector<float> heights(kSide * kSide * kSide);
  const auto at = [](int x, int y, int z) {
    return std::size_t((wrapped(z, kSide) * kSide + wrapped(y, kSide)) * kSide + wrapped(x, kSide));
  };
  parallelFor(kSide, [&](std::ptrdiff_t z) {
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        heights[at(x, y, int(z))] = height((glm::vec3(x, y, float(z)) + 0.5f) / float(kSide));
  });
  constexpr float kPerStep = kSide / (2 * DetailTile::kLength);
  std::vector<glm::vec4> texels(heights.size());
  double squared = 0;
  for (int z = 0; z < kSide; ++z)
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const glm::vec3 gradient = kPerStep * glm::vec3(heights[at(x + 1, y, z)] - heights[at(x - 1, y, z)],
                                                        heights[at(x, y + 1, z)] - heights[at(x, y - 1, z)],
                                                        heights[at(x, y, z + 1)] - heights[at(x, y, z - 1)]);
        texels[at(x, y, z)] = glm::vec4(gradient, heights[at(x, y, z)]);
        squared += glm::dot(gradient, gradient) / 3;
      }
  DetailTile tile;
  tile.meanSlope = float(squared / double(texels.size()));
  tile.texture =
      gl::Texture({.size = glm::ivec3(kSide), .format = gl::Format::rgba16f, .wrap = gl::Wrap::repeat});
  tile.texture.upload(texels.data());
  return tile;
}

}  // namespace sonoskin
