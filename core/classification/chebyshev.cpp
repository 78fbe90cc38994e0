#include "core/classification/chebyshev.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/base/parallel.h"
#include "core/classification/residual.h"

namespace sonoskin {
namespace {

constexpr int kMaxSweeps = 100;
constexpr double kDiverged = 8;  // times the smallest residual so far
constexpr float kWakePerRest = 4;
constexpr float kRestPerTolerance = 2;
// The smallest eigenvalue is not reached: voxels with the smallest c/D have neighbours with larger ones.
constexpr double kLowestOverBound = 2;

// The two numbers of each step, by the recurrence of Chebyshev's polynomials.
class ChebyshevSteps {
 public:
  ChebyshevSteps(double lowest, double highest)
      : centre_((highest + lowest) / 2), radius_((highest - lowest) / 2), sigma_(centre_ / radius_) {}
  struct Step {
    float momentum, length;
  };
  Step next() {
    const double before = rho_;
    rho_ = before == 0 ? 1 / sigma_ : 1 / (2 * sigma_ - before);
    if (before == 0) return {0, float(1 / centre_)};
    return {float(rho_ * before), float(2 * rho_ / radius_)};
  }

 private:
  double centre_, radius_, sigma_, rho_ = 0;
};

// What a sweep finds in one tile.
struct TileState {
  float residual = 0;  // sum of squares of b - A u
  float step = 0;      // the largest |D^-1 (b - A u)|
};

// Asks for the rows that will be read next (see TileSweep).
void fetchAhead(const ScaledSystem& system, const float* next, std::size_t at, int count) {
  constexpr int kLine = 64;  // bytes
  for (int x = 0; x < count; x += kLine / int(sizeof(float))) __builtin_prefetch(next + at + x, 1);
  for (const auto* part : {&system.right, &system.own, &system.inverse})
    for (int x = 0; x < count; x += kLine / int(sizeof(Half))) __builtin_prefetch(part->data() + at + x);
}

// A row of voxels: from voxel `at` on, with K u, u, and the u before in `next`.
struct VoxelRow {
  std::size_t at;
  int count;
  const float *ku, *u;
  float* next;
};

// One row: makes the u before the u after. In the first step nothing came before.
template <bool First>
void advanceRow(const ScaledSystem& system, ChebyshevSteps::Step step, const VoxelRow& row,
                TileState& state) {
  const Half *right = &system.right[row.at], *own = &system.own[row.at], *inverse = &system.inverse[row.at];
  const float *ku = row.ku, *u = row.u;
  float* next = row.next;
  const int count = row.count;
  const float momentum = step.momentum, length = step.length;
  float sum = 0, largest = state.step;
#pragma omp simd reduction(+ : sum) reduction(max : largest)
  for (int i = 0; i < count; ++i) {
    const float d = toFloat(inverse[i]);
    const float scaled = toFloat(right[i]) - toFloat(own[i]) * u[i] - d * ku[i];
    const float residual = scaled / d;
    sum += residual * residual;
    largest = std::max(largest, std::abs(scaled));
    if constexpr (First) {
      next[i] = u[i] + length * scaled;
    } else {
      next[i] = u[i] + momentum * (u[i] - next[i]) + length * scaled;
    }
  }
  state.residual += sum;
  state.step = largest;
}

std::size_t voxelsOf(const Tile& tile) {
  const glm::ivec3 size = tile.last - tile.first;
  return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
}

// The iteration: which tiles still move, and the two buffers that take turns.
class Iteration {
 public:
  Iteration(const NeighbourTerms& k, const ScaledSystem& system, LargeArray<float>& u,
            LargeArray<float>& scratch, const Progress& progress)
      : k_(k),
        system_(system),
        u_(u),
        scratch_(scratch),
        progress_(progress),
        counts_(tileCounts(k.geometry().dims)),
        tiles_(tilesOf(k.geometry().dims)),
        states_(tiles_.size()),
        moves_(tiles_.size(), true),
        steps_(std::min(kLowestOverBound * system.leastOwn, 1.0), highestEigenvalue()) {
    setMoving([&](std::size_t t) { return system_.coupling[t] > kLooseCoupling; });
  }

  void sweep() {
    const ChebyshevSteps::Step step = steps_.next();
    parallelFor(
        std::ptrdiff_t(moving_.size()), [&](std::ptrdiff_t m) { sweepTile(moving_[std::size_t(m)], step); },
        progress_);
    std::swap(u_, scratch_);
    for (const std::size_t t : moving_) updates_ += voxelsOf(tiles_[t]);
  }

  // rest: tiles whose voxels hardly move any more stay as they are, until a neighbour pulls at them.
  void rest(double tolerance) {
    const float step = kRestPerTolerance * float(tolerance), share = float(tolerance * tolerance);
    setMoving([&](std::size_t t) {
      const TileState& state = states_[t];
      return state.step > step || state.residual > share * system_.squares[t] ||
             (system_.coupling[t] > kLooseCoupling && neighboursMove(t, kWakePerRest * step));
    });
  }

  bool anyMoves() const { return !moving_.empty(); }
  std::size_t updates() const { return updates_; }
  double relativeResidual() const {
    double sum = 0;
    for (const TileState& state : states_) sum += double(state.residual);
    return system_.norm > 0 ? std::sqrt(sum) / system_.norm : 0;
  }

 private:
  // A bound: the power method finds a third less, but finding it costs more sweeps than it saves.
  double highestEigenvalue() const {
    const double most = k_.largestEigenvalue();
    return most - (most - 1) * system_.leastOwn;  // c/D has the eigenvalue 1
  }

  void sweepTile(std::size_t t, ChebyshevSteps::Step step) {
    const Tile& tile = tiles_[t];
    const auto advance = step.momentum == 0 ? advanceRow<true> : advanceRow<false>;
    TileState state;
    k_.apply(u_.data(), tile, [&](int j, int slice, const float* ku) {
      const std::size_t at = k_.geometry().index(tile.first.x, j, slice);
      const int width = tile.last.x - tile.first.x;
      fetchAhead(system_, scratch_.data(),
                 std::min(at + 2 * std::size_t(k_.geometry().dims.x), u_.size() - 1), width);
      advance(system_, step, {at, width, ku, &u_[at], &scratch_[at]}, state);
    });
    states_[t] = state;
  }

  // Whether one of the six neighbours of a tile moves by more than `least`.
  bool neighboursMove(std::size_t t, float least) const {
    const std::size_t row = std::size_t(counts_.x), layer = row * std::size_t(counts_.y);
    const std::size_t a = t % row, b = t / row % std::size_t(counts_.y), c = t / layer;
    const auto step = [&](bool inside, std::size_t other) { return inside && states_[other].step > least; };
    return step(a > 0, t - 1) || step(a + 1 < row, t + 1) || step(b > 0, t - row) ||
           step(b + 1 < std::size_t(counts_.y), t + row) || step(c > 0, t - layer) ||
           step(c + 1 < std::size_t(counts_.z), t + layer);
  }

  // setMoving: asks moves(t) for every tile. Both buffers hold the same where nothing moves any more.
  template <class Moves>
  void setMoving(const Moves& moves) {
    std::vector<std::size_t> resting;
    moving_.clear();
    for (std::size_t t = 0; t < tiles_.size(); ++t) {
      const bool moved = moves_[t];
      moves_[t] = moves(t);
      if (moves_[t]) moving_.push_back(t);
      if (moved && !moves_[t]) resting.push_back(t);
    }
    parallelFor(
        std::ptrdiff_t(resting.size()), [&](std::ptrdiff_t m) { copyTile(tiles_[resting[std::size_t(m)]]); },
        progress_);
  }

  void copyTile(const Tile& tile) {
    for (int k = tile.first.z; k < tile.last.z; ++k)
      for (int j = tile.first.y; j < tile.last.y; ++j) {
        const std::size_t at = k_.geometry().index(tile.first.x, j, k);
        std::copy_n(&u_[at], tile.last.x - tile.first.x, &scratch_[at]);
      }
  }

  const NeighbourTerms& k_;
  const ScaledSystem& system_;
  LargeArray<float>&u_, &scratch_;
  Progress progress_;
  glm::ivec3 counts_;
  std::vector<Tile> tiles_;
  std::vector<TileState> states_;  // per tile, of its last sweep
  std::vector<char> moves_;        // per tile
  std::vector<std::size_t> moving_;
  ChebyshevSteps steps_;
  std::size_t updates_ = 0;
};

}  // namespace

FastSolution solveFast(const NeighbourTerms& k, const ScaledSystem& system, double tolerance,
                       LargeArray<float>& u, LargeArray<float>& scratch, const Progress& progress) {
  Iteration iteration(k, system, u, scratch, progress.cancelOnly());
  FastSolution solution;
  double first = 0, least = 0;
  while (solution.sweeps < kMaxSweeps && !solution.converged) {
    iteration.sweep();
    ++solution.sweeps;
    solution.residual = iteration.relativeResidual();
    if (solution.sweeps == 1) first = least = solution.residual;
    if (!(solution.residual <= kDiverged * least)) break;
    iteration.rest(tolerance);
    solution.converged = solution.residual <= tolerance || !iteration.anyMoves();
    progress.update(fractionOfResidual(solution.residual, first, tolerance));
    least = std::min(least, solution.residual);
  }
  solution.updates = iteration.updates();
  return solution;
}

}  // namespace sonoskin
