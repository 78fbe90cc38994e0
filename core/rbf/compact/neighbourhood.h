#pragma once

#include <span>

#include "core/rbf/compact/local_quadric.h"
#include "core/rbf/sorted_points.h"

namespace sonoskin {

// Neighbourhood: the points around one centre, gathered once for fits with many supports. Scratch memory of
// one thread: keep it from centre to centre.
//   threads   one object per thread
class Neighbourhood {
 public:
  // gather: takes the points closer than `radius` to point `centre`.
  void gather(const SortedPoints& points, std::size_t centre, float radius);

  std::size_t size() const { return count_; }

  // meanNormal: n_c = normalise(Σ_j w_j n_j [n_j·n_i > 0]), w_j = d_j φ(r_j/σ); the centre's own where the
  // sum vanishes.                                                    [thesis 3.15, normalised, gated by
  // Ohtake et al.]
  glm::vec3 meanNormal(float sigma) const;

  // project: turns the points into the frame, ordered so that those closer than smallest * 2^(k/2) come
  // first, for every k.
  void project(const Frame& frame, float smallest);

  // within: after project(), the points closer than sigma, and perhaps some up to sqrt(2) times as far.
  LocalSamples within(float sigma) const;

  // countWithin: how many points are closer than sigma.
  std::size_t countWithin(float sigma) const;

  // select: the points closer than sigma in the frame, in ascending order of sorted points; undoes project().
  void select(const Frame& frame, float sigma);

  // selection: what select() took, and the sorted points that they are.
  LocalSamples selection() const {
    return {u_.data(), v_.data(), w_.data(), r_.data(), levelD_.data(), selectedCount_};
  }
  std::span<const std::uint32_t> selected() const { return {level_.data(), selectedCount_}; }

 private:
  static constexpr std::size_t kLevels = 48;

  void reserve(std::size_t count);
  void gatherRun(const SortedPoints& points, std::size_t first, std::size_t last, float limit);

  glm::vec3 centre_{0};
  std::size_t count_ = 0, selectedCount_ = 0;
  glm::vec3 ownNormal_{0, 0, 1};
  std::vector<std::uint32_t> index_;           // sorted point
  std::vector<float> dx_, dy_, dz_, squared_;  // relative to the centre, and squared distance
  std::vector<float> nx_, ny_, nz_, d_;        // normal and influence
  std::vector<float> u_, v_, w_, r_, levelD_;  // in the frame, by level
  std::vector<std::uint32_t>
      level_;  // k: smallest 2^((k-1)/2) <= r < smallest 2^(k/2); or the selected points
  std::array<std::size_t, kLevels + 1> levelEnd_{};  // points of levels up to k
  float smallest_ = 1;
};

}  // namespace sonoskin
