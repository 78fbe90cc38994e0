#pragma once

#include <cstdint>
#include <vector>

#include "core/surface/surface_points.h"
#include "core/volume/scan.h"

namespace sonoskin {

// FaceInput: where a face is looked for. World mm.
//   points     on the skin and on whatever else was found, normals outward
//   lowPassed  the volume; without it nothing is known of what lies between the points
//   fluid      grey below which the volume is fluid or shadow
struct FaceInput {
  const SurfacePoints& points;
  const Volume<float>* lowPassed = nullptr;
  float fluid = 0;
  Beam beam{};
};

// Surfel: the mean of the points in a cell.
struct Surfel {
  glm::vec3 place, normal;
};

// FaceSpace: what lies where, on a coarse grid around the points: the nearest surfel, and whether skin could be there.
//   free     fluid through which sound passed to a surface behind: there is no skin
//   dark     fluid or shadow
//   unknown  anything else, or outside the grid
class FaceSpace {
 public:
  enum class Kind : std::uint8_t { unknown, free, dark };

  // cost   20 ms of one core for 50,000 points
  explicit FaceSpace(const FaceInput& input);

  const std::vector<Surfel>& surfels() const { return surfels_; }
  float cell() const { return cell_; }
  // nearest: the surfel nearest to a place, by less than a cell's diagonal; null farther than kReach cells.
  const Surfel* nearest(const glm::vec3& place) const {
    const std::ptrdiff_t at = indexOf(place);
    return at < 0 || nearest_[std::size_t(at)] == kNone ? nullptr : &surfels_[nearest_[std::size_t(at)]];
  }
  Kind kind(const glm::vec3& place) const {
    const std::ptrdiff_t at = indexOf(place);
    return at < 0 ? Kind::unknown : kinds_[std::size_t(at)];
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  static constexpr float kReach = 8;

  std::ptrdiff_t indexOf(const glm::vec3& place) const {
    const glm::vec3 c = (place - low_) * inverse_;
    if (!(c.x >= 0 && c.y >= 0 && c.z >= 0)) return -1;
    const glm::ivec3 i(c);
    if (i.x >= dims_.x || i.y >= dims_.y || i.z >= dims_.z) return -1;
    return (std::ptrdiff_t(i.z) * dims_.y + i.y) * dims_.x + i.x;
  }
  glm::vec3 centreOf(int i, int j, int k) const { return low_ + cell_ * (glm::vec3(i, j, k) + 0.5f); }

  void place(const SurfacePoints& points);
  void gather(const SurfacePoints& points);
  void dropStrays();
  void spread();
  void findFree(const FaceInput& input);
  Kind kindOf(const FaceInput& input, const glm::vec3& centre, const glm::vec3& along,
              const glm::vec3& next) const;

  glm::vec3 low_{0};
  float cell_ = 1, inverse_ = 1;
  glm::ivec3 dims_{0};
  std::vector<Surfel> surfels_;
  std::vector<std::uint32_t> nearest_;
  std::vector<Kind> kinds_;
};

}  // namespace sonoskin
