#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

// Random numbers by counter: the value at an index depends on the index and a key only, so that it is the
// same whichever thread asks, in whatever order.
namespace sonoskin {

// scramble: a bijection of 32-bit numbers without visible pattern.  [Wellons 2018, lowbias32]
inline std::uint32_t scramble(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  x ^= x >> 16;
  return x;
}

// streamKey: the key of one of several independent streams of a seed.
inline std::uint32_t streamKey(int seed, std::uint32_t stream) {
  return scramble(scramble(std::uint32_t(seed)) + 0x9e3779b9u * (stream + 1));
}

// uniformAt: in [0, 1).
inline float uniformAt(std::uint32_t index, std::uint32_t key) {
  return float(scramble(scramble(index ^ key) + key) >> 8) * 0x1p-24f;
}

// normalAt: nearly normal, mean 0, variance 1: the sum of the four bytes of a random word (Irwin-Hall;
// |value| < 3.5, excess kurtosis -0.3, which a blur over a few samples removes).
inline float normalAt(std::uint32_t index, std::uint32_t key) {
  const std::uint32_t h = scramble(scramble(index ^ key) + key);
  const std::uint32_t pairs = (h & 0x00ff00ffu) + ((h >> 8) & 0x00ff00ffu);
  const std::int32_t sum = std::int32_t((pairs & 0xffffu) + (pairs >> 16));
  return float(sum - 510) * 0.0067658f;  // sqrt(12 / (4 (256^2 - 1)))
}

// valueNoise: smooth noise in [0, 1] with grains of `size` mm, trilinear between random lattice values.
inline float valueNoise(const glm::vec3& p, float size, std::uint32_t key) {
  const glm::vec3 q = p / size, base = glm::floor(q);
  glm::vec3 t = q - base;
  t = t * t * (3.f - 2.f * t);
  const glm::ivec3 b(base);
  const auto lattice = [&](int x, int y, int z) {
    const auto word = std::uint32_t(b.x + x) * 0x8da6b343u + std::uint32_t(b.y + y) * 0xd8163841u +
                      std::uint32_t(b.z + z) * 0xcb1ab31fu;
    return uniformAt(word, key);
  };
  const auto alongX = [&](int y, int z) { return glm::mix(lattice(0, y, z), lattice(1, y, z), t.x); };
  return glm::mix(glm::mix(alongX(0, 0), alongX(1, 0), t.y), glm::mix(alongX(0, 1), alongX(1, 1), t.y), t.z);
}

}  // namespace sonoskin
