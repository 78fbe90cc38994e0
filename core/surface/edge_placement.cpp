#include "core/surface/edge_placement.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/parallel_blocks.h"
#include "core/mesh/search/point_grid.h"
#include "core/surface/skin_depth.h"
#include "core/volume/sample.h"

namespace sonoskin {
namespace {

constexpr int kReach = 14;       // samples to either side
constexpr int kPad = 6;          // more of them, for the derivative
constexpr float kSample = 0.5f;  // smallest spacings between samples
constexpr float kSlopeSigma =
    2;  // samples: the Gaussian whose derivative takes the slope, one smallest spacing
constexpr float kAroundVoxels =
    2;  // neighbours whose slopes are averaged: of a voxel's size, the cube root of its volume
constexpr float kMedianAround = 1.25f, kNoiseAround = 2;  // of that
constexpr float kLeastAround = 1.5f;                      // mm
constexpr float kLikely = 2.0f;                           // mm: how far from the mean profile's edge one lies
constexpr float kStep = 0.5f;                             // mm: more than neighbours differ
constexpr float kSameSide = 0.5f;                         // least cosine between the normals of neighbours
constexpr double kWidthOfVoxels =
    1.45;  // smallest spacings: what sampling and averaging add to an edge's width, squared
constexpr float kLeastSlope = 1e-4f;
constexpr std::size_t kPointsPerTask = 256;
constexpr std::size_t kCount = 2 * kReach + 1;

using Profile = std::array<float, kCount>;  // from outside to inside; kReach is the point itself

// The weights of the derivative of a Gaussian, for differences of the samples at d and -d.
std::array<float, kPad> slopeWeights() {
  std::array<float, kPad> weights{};
  float sum = 0;
  for (int d = 1; d <= kPad; ++d) {
    weights[std::size_t(d - 1)] = float(d) * std::exp(-0.5f * float(d * d) / (kSlopeSigma * kSlopeSigma));
    sum += 2 * float(d) * weights[std::size_t(d - 1)];
  }
  for (float& w : weights) w /= sum;  // a ramp of 1 per sample has the slope 1
  return weights;
}

// Where a function that is sampled at whole numbers is greatest, by the parabola through three values.
float peakAround(const Profile& values, int at) {
  if (at <= 0 || at + 1 >= int(kCount)) return float(at);
  const float before = values[std::size_t(at - 1)], after = values[std::size_t(at + 1)];
  const float bend = before - 2 * values[std::size_t(at)] + after;
  return bend < 0 ? float(at) + std::clamp(0.5f * (before - after) / bend, -0.5f, 0.5f) : float(at);
}

float voxelSize(const Geometry& g) { return float(std::cbrt(g.spacing.x * g.spacing.y * g.spacing.z)); }

// The bits of a float as a whole number that is ordered as floats are; of such a number the float's bits again.
std::int32_t ordered(std::int32_t bits) { return bits ^ ((bits >> 31) & 0x7fffffff); }

// The one in the middle: bisects its bits, counting what lies below, which loops over vectors do five times as fast as a
// partition of some hundred numbers that nobody can predict.
float medianOf(const std::vector<float>& values) {
  thread_local std::vector<std::int32_t> order;
  order.resize(values.size());
  std::int32_t least = std::numeric_limits<std::int32_t>::max(), most = ~least;
  const std::size_t count = values.size();
  for (std::size_t v = 0; v < count; ++v) {
    order[v] = ordered(std::bit_cast<std::int32_t>(values[v]));
    least = std::min(least, order[v]);
    most = std::max(most, order[v]);
  }
  const std::int32_t* numbers = order.data();
  std::int64_t low = least, high = most;  // the greatest number that no more than half of all lie below
  while (low < high) {
    const std::int64_t middle = (low + high + 1) >> 1;
    const auto border = std::int32_t(middle);
    std::int32_t below = 0;
    for (std::size_t v = 0; v < count; ++v) below += numbers[v] < border;
    if (std::size_t(below) <= count / 2)
      low = middle;
    else
      high = middle - 1;
  }
  return std::bit_cast<float>(ordered(std::int32_t(low)));
}

// Edges: the points in the order of a grid, with what was measured at them. Places along normals are in samples from the
// point, positive inward.
class Edges {
 public:
  Edges(const SurfacePoints& points, const Volume<float>& volume)
      : volume_(volume),
        sample_(kSample * float(volume.geometry.minSpacing())),
        around_(std::max(kLeastAround, kAroundVoxels * voxelSize(volume.geometry))),
        grid_(points.positions, around_),
        position_(points.size()),
        normal_(points.size()),
        grey_(points.size()),
        slope_(points.size()),
        place_(points.size()) {
    for (std::size_t s = 0; s < points.size(); ++s) {
      position_[s] = points.positions[grid_.order()[s]];
      normal_[s] = points.normals[grid_.order()[s]];
    }
  }

  void sampleSlopes(const Progress& progress) {
    const std::array<float, kPad> weights = slopeWeights();
    forEachPoint(progress, [&](std::size_t s) {
      std::array<float, kCount + 2 * kPad> grey;
      sampleAlongNormal(s, grey.data(), int(grey.size()));
      for (std::size_t t = 0; t < kCount; ++t) {
        float sum = 0;
        for (std::size_t d = 1; d <= kPad; ++d)
          sum += weights[d - 1] * (grey[t + kPad + d] - grey[t + kPad - d]);
        slope_[s][t] = sum;
        grey_[s][t] = grey[t + kPad];
      }
    });
  }

  // The mean slope's greatest place; nothing if the grey rises nowhere.
  bool findMean() {
    std::array<double, kCount> mean{};
    for (const Profile& slope : slope_)
      for (std::size_t t = 0; t < kCount; ++t) mean[t] += double(slope[t]);
    const auto most = std::max_element(mean.begin(), mean.end());
    mean_ = int(most - mean.begin());
    for (std::size_t t = 0; t < kCount; ++t) {
      const float away = (float(t) - float(mean_)) * sample_ / kLikely;
      likely_[t] = std::exp(-0.5f * away * away);
    }
    return *most > double(kLeastSlope) * double(slope_.size());
  }

  void findPlaces(const Progress& progress) {
    forEachPoint(progress, [&](std::size_t s) { place_[s] = edgeOf(slopeAround(s), mean_); });
  }

  // Places that stand out are taken from their neighbours.
  void dropOutliers(const Progress& progress) {
    std::vector<float> calm(place_.size());
    forEachPoint(progress, [&](std::size_t s) {
      thread_local std::vector<float> around;
      around.clear();
      forEachNeighbour(s, kMedianAround * around_,
                       [&](std::size_t o, float outward, float) { around.push_back(place_[o] - outward); });
      const float median = medianOf(around);
      calm[s] = std::abs(place_[s] - median) * sample_ > kStep ? median : place_[s];
    });
    place_ = std::move(calm);
  }

  // The standard deviation of single places from the averaged ones around each point, mm.
  std::vector<float> measureNoise(const Progress& progress) const {
    constexpr float kFromMedian =
        1.4826f;  // of absolute differences to the standard deviation of a normal distribution
    std::vector<float> difference(place_.size()), noise(place_.size());
    forEachPoint(progress.part(0, 0.5), [&](std::size_t s) {
      difference[s] = edgeOf(slope_[s], int(std::lround(place_[s])) + kReach) - place_[s];
    });
    forEachPoint(progress.part(0.5, 1), [&](std::size_t s) {
      thread_local std::vector<float> around;
      around.clear();
      forEachNeighbour(s, kNoiseAround * around_,
                       [&](std::size_t o, float, float) { around.push_back(difference[o]); });
      const float middle = medianOf(around);  // curved surfaces shift all averages alike
      for (float& d : around) d = std::abs(d - middle);
      noise[s] = kFromMedian * medianOf(around) * sample_;
    });
    return noise;
  }

  EdgeProfile meanProfile() const;

  // Moves the points to their places.
  void move(SurfacePoints& points, const std::vector<float>& noise) const {
    points.noise.resize(points.size());
    for (std::size_t s = 0; s < place_.size(); ++s) {
      const std::size_t p = grid_.order()[s];
      points.positions[p] -= place_[s] * sample_ * normal_[s];
      points.noise[p] = noise[s];
    }
  }

 private:
  template <class Body>
  void forEachPoint(const Progress& progress, const Body& body) const {
    parallelItems(position_.size(), kPointsPerTask, body, progress);
  }

  // Calls f(neighbour, samples that it lies outward, weight) for those on the same side, the point itself included.
  template <class F>
  void forEachNeighbour(std::size_t s, float radius, const F& f) const {
    const float perSquare = 1 / (radius * radius);
    grid_.forEachRun(position_[s], radius, [&](std::size_t first, std::size_t last) {
      for (std::size_t o = first; o < last; ++o) {
        const glm::vec3 d = position_[o] - position_[s];
        const float rest = 1 - glm::dot(d, d) * perSquare, cosine = glm::dot(normal_[o], normal_[s]);
        if (rest > 0 && cosine > kSameSide) f(o, glm::dot(d, normal_[s]) / sample_, rest * rest * cosine);
      }
    });
  }

  void sampleAlongNormal(std::size_t s, float* grey, int count) const {
    const Geometry& g = volume_.geometry;
    const glm::vec3 start(g.toIndex(glm::dvec3(position_[s])));
    const glm::vec3 inward =
        glm::vec3(glm::transpose(g.direction) * glm::dvec3(-normal_[s])) * sample_ / glm::vec3(g.spacing);
    for (int t = 0; t < count; ++t) grey[t] = sampleTrilinear(volume_, start + float(t - count / 2) * inward);
  }

  // The mean slope around a point: a neighbour that lies outward has its edge as much deeper.
  Profile slopeAround(std::size_t s) const {
    Profile sum{};
    forEachNeighbour(s, around_, [&](std::size_t o, float outward, float weight) {
      const int whole = int(std::floor(outward));
      const float part = outward - float(whole);
      const Profile& slope = slope_[o];
      const int first = std::max(0, -whole), last = std::min(int(kCount), int(kCount) - 1 - whole);
      for (int t = first; t < last; ++t)
        sum[std::size_t(t)] +=
            weight * ((1 - part) * slope[std::size_t(t + whole)] + part * slope[std::size_t(t + whole + 1)]);
    });
    return sum;
  }

  // The likeliest edge in a slope, around the index `expected`; in samples from the point.
  float edgeOf(const Profile& slope, int expected) const {
    int best = std::clamp(expected, 0, int(kCount) - 1);
    float most = 0;
    for (int t = 0; t < int(kCount); ++t) {
      const int away = t - expected + mean_;  // likely_ has its maximum at the mean
      if (away < 0 || away >= int(kCount)) continue;
      const float value = slope[std::size_t(t)] * likely_[std::size_t(away)];
      if (value > most) most = value, best = t;
    }
    return peakAround(slope, best) - float(kReach);
  }

  const Volume<float>& volume_;
  float sample_, around_;  // mm
  PointGrid grid_;
  std::vector<glm::vec3> position_, normal_;
  std::vector<Profile> grey_, slope_;
  std::vector<float> place_;
  int mean_ = kReach;
  Profile likely_{};
};

// Where a rising profile passes `level`, from index `from` on in steps of `step`.
double crossing(const std::array<double, kCount>& grey, int from, int step, double level) {
  for (int t = from; t + step >= 0 && t + step < int(kCount); t += step) {
    const double a = grey[std::size_t(t)], b = grey[std::size_t(t + step)];
    if ((a - level) * (b - level) <= 0 && a != b) return double(t) + double(step) * (level - a) / (b - a);
  }
  return step > 0 ? double(kCount - 1) : 0.0;
}

EdgeProfile Edges::meanProfile() const {
  std::array<double, kCount> grey{};
  std::array<double, kCount> counts{};
  for (std::size_t s = 0; s < place_.size(); ++s) {
    const int whole = int(std::lround(place_[s]));
    for (int t = std::max(0, -whole); t < std::min(int(kCount), int(kCount) - whole); ++t) {
      grey[std::size_t(t)] += double(grey_[s][std::size_t(t + whole)]);
      counts[std::size_t(t)] += 1;
    }
  }
  for (std::size_t t = 0; t < kCount; ++t) grey[t] = counts[t] > 0 ? grey[t] / counts[t] : 0;
  EdgeProfile profile;
  profile.steepest = grey[kReach];
  profile.dark = *std::min_element(grey.begin(), grey.begin() + kReach);
  profile.bright = *std::max_element(grey.begin() + kReach, grey.end());
  const double rise = profile.bright - profile.dark;
  const double measured = (crossing(grey, kReach, 1, profile.dark + 0.8 * rise) -
                           crossing(grey, kReach, -1, profile.dark + 0.2 * rise)) *
                          double(sample_);
  const double ofVoxels = kWidthOfVoxels * volume_.geometry.minSpacing();
  profile.width = std::sqrt(std::max(measured * measured - ofVoxels * ofVoxels, 0.09 * measured * measured));
  profile.shift = double(medianOf(place_) * sample_);
  return profile;
}

}  // namespace

EdgeProfile placeOnEdges(SurfacePoints& points, const Volume<float>& volume, double depthShare,
                         const Progress& progress) {
  if (points.size() == 0) return {};
  Edges edges(points, volume);
  edges.sampleSlopes(progress.part(0, 0.2));
  if (!edges.findMean()) return {};
  edges.findPlaces(progress.part(0.2, 0.6));
  edges.dropOutliers(progress.part(0.6, 0.8));
  EdgeProfile profile = edges.meanProfile();
  profile.depth = depthShare * profile.width;
  edges.move(points, edges.measureNoise(progress.part(0.8, 0.9)));
  moveOntoSkin(points, float(profile.depth), progress.part(0.9, 1));
  progress.update(1);
  return profile;
}

}  // namespace sonoskin
