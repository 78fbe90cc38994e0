#include "core/surface/skin_depth.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel_blocks.h"
#include "core/mesh/search/point_grid.h"

namespace sonoskin {
namespace {

constexpr float kAround = 1.5f;     // mm over which normals and depths are averaged
constexpr float kThinnest = 4;      // times the depth: thinner bodies get less
constexpr float kSameSide = 0.3f;   // least cosine between the normals of neighbours
constexpr float kOpposite = -0.3f;  // largest cosine between the normals of two sides
constexpr float kAcross = 0.6f;     // of their distance: how far sides may lie beside each other's normal
constexpr std::size_t kPointsPerTask = 256;

// Inward: the points in the order of a grid, and how each moves.
class Inward {
 public:
  Inward(const SurfacePoints& points, float depth)
      : depth_(depth), grid_(points.positions, std::max(kAround, kThinnest * depth)) {
    for (const std::uint32_t p : grid_.order()) {
      position_.push_back(points.positions[p]);
      normal_.push_back(points.normals[p]);
    }
    thin_.resize(position_.size());
    by_.resize(position_.size());
  }

  void measureThickness(const Progress& progress) {
    forEachPoint(progress, [&](std::size_t s) { thin_[s] = std::min(depth_, thickness(s) / kThinnest); });
  }

  void findWays(const Progress& progress) {
    forEachPoint(progress, [&](std::size_t s) {
      glm::vec3 normal(0);
      float sum = 0, depth = 0;
      forEachNear(s, kAround, [&](std::size_t o, const glm::vec3& away) {
        if (glm::dot(normal_[o], normal_[s]) < kSameSide) return;
        const float rest = std::max(1 - glm::dot(away, away) / (kAround * kAround), 0.f);
        normal += rest * normal_[o];
        depth += rest * thin_[o], sum += rest;
      });
      by_[s] = -depth / sum * glm::normalize(normal);
    });
  }

  void move(SurfacePoints& points) const {
    for (std::size_t s = 0; s < by_.size(); ++s) points.positions[grid_.order()[s]] += by_[s];
  }

 private:
  template <class Body>
  void forEachPoint(const Progress& progress, const Body& body) const {
    parallelItems(position_.size(), kPointsPerTask, body, progress);
  }

  // Calls f(another point or this one, the way to it).
  template <class F>
  void forEachNear(std::size_t s, float radius, const F& f) const {
    grid_.forEachRun(position_[s], radius, [&](std::size_t first, std::size_t last) {
      for (std::size_t o = first; o < last; ++o) f(o, position_[o] - position_[s]);
    });
  }

  // The way inward to another side of the body, mm; far where there is none within reach.
  float thickness(std::size_t s) const {
    const float reach = kThinnest * depth_;
    float least = reach;
    forEachNear(s, reach, [&](std::size_t o, const glm::vec3& away) {
      if (glm::dot(normal_[o], normal_[s]) > kOpposite) return;
      const float inward = -glm::dot(away, normal_[s]);
      const float square = glm::dot(away, away);
      if (inward > 0 && square - inward * inward < kAcross * kAcross * square)
        least = std::min(least, inward);
    });
    return least;
  }

  float depth_;
  PointGrid grid_;
  std::vector<glm::vec3> position_, normal_, by_;
  std::vector<float> thin_;
};

}  // namespace

void moveOntoSkin(SurfacePoints& points, float depth, const Progress& progress) {
  if (points.size() == 0 || !(depth > 0)) return;
  Inward inward(points, depth);
  inward.measureThickness(progress.part(0, 0.5));
  inward.findWays(progress.part(0.5, 1));
  inward.move(points);
}

}  // namespace sonoskin
