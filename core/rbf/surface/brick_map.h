#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace sonoskin {

// BrickMap: numbers for a few of the bricks of a big lattice. Two levels: blocks of 8³ bricks are allocated when
// first touched, so memory follows the surface, not the volume.
class BrickMap {
 public:
  static constexpr std::int32_t kNone = -1;

  BrickMap() = default;
  explicit BrickMap(const glm::ivec3& bricks)
      : bricks_(bricks),
        blocks_((bricks + kEdge - 1) / kEdge),
        block_(std::size_t(blocks_.x) * std::size_t(blocks_.y) * std::size_t(blocks_.z), kNone) {}

  const glm::ivec3& bricks() const { return bricks_; }
  bool contains(const glm::ivec3& b) const {
    return b.x >= 0 && b.y >= 0 && b.z >= 0 && b.x < bricks_.x && b.y < bricks_.y && b.z < bricks_.z;
  }
  // find: the brick's number; kNone without one and outside the lattice.
  std::int32_t find(const glm::ivec3& b) const {
    if (!contains(b)) return kNone;
    const std::int32_t block = block_[blockIndex(b)];
    return block == kNone ? kNone : numbers_[std::size_t(block) * kBlockSize + innerIndex(b)];
  }
  // insert: gives a brick inside the lattice its number.
  void insert(const glm::ivec3& b, std::int32_t number) {
    std::int32_t& block = block_[blockIndex(b)];
    if (block == kNone) {
      block = std::int32_t(numbers_.size() / kBlockSize);
      numbers_.resize(numbers_.size() + kBlockSize, kNone);
    }
    numbers_[std::size_t(block) * kBlockSize + innerIndex(b)] = number;
  }

 private:
  static constexpr int kEdge = 8;
  static constexpr std::size_t kBlockSize = std::size_t(kEdge) * kEdge * kEdge;

  // Places are not negative here, and unsigned numbers divide by a shift.
  std::size_t blockIndex(const glm::ivec3& b) const {
    const glm::uvec3 block = glm::uvec3(b) / unsigned(kEdge);
    return (std::size_t(block.z) * std::size_t(blocks_.y) + block.y) * std::size_t(blocks_.x) + block.x;
  }
  static std::size_t innerIndex(const glm::ivec3& b) {
    const glm::uvec3 inner = glm::uvec3(b) % unsigned(kEdge);
    return std::size_t((inner.z * kEdge + inner.y) * kEdge + inner.x);
  }

  glm::ivec3 bricks_{0}, blocks_{0};
  std::vector<std::int32_t> block_, numbers_;
};

}  // namespace sonoskin
