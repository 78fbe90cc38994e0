#include "core/surface/echo_offset.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"
#include "core/volume/sample.h"

namespace sonoskin {
namespace {

// The share is calibrated on the simulated scan (467x255x124, voxels of 0.3 x 0.3 x 0.9 mm), where the true skin is
// known. True offset -> measured, mm (medians over the visible skin), for several iso-values and low-passes
// (voxels), at three noise levels (phantom.snr):
//
//   iso         low-pass   20 dB             13 dB             8 dB
//   automatic   1.0        0.70 -> 0.54      0.50 -> 0.46      0.39 -> 0.40
//   automatic   1.5        0.77 -> 0.65      0.58 -> 0.57      0.47 -> 0.53
//   automatic   2.5        0.94 -> 0.86      0.77 -> 0.79      0.59 -> 0.68
//   0.35        1.0        0.45 -> 0.37      0.51 -> 0.46      0.46 -> 0.49
//   0.35        1.5        0.48 -> 0.41      0.58 -> 0.56      0.53 -> 0.58
//   0.35        2.5        0.52 -> 0.46      0.73 -> 0.75      nothing found
//   0.5         1.0        0.23 -> 0.21      0.23 -> 0.26      0.25 -> 0.30
//   0.5         1.5        0.23 -> 0.27      0.26 -> 0.34      0.32 -> 0.42
//   0.5         2.5        0.22 -> 0.16      0.28 -> 0.31      0.41 -> 0.49
//
// With voxels twice as large (234x128x62) the offsets are up to 1.3 mm and the errors at most 0.14 mm. Corrections that
// follow the beam's angle or the range, or patches of 8 mm, would take another tenth off the scatter: not worth steps in
// the surface.
constexpr double kSkinRise = 0.82;
constexpr double kLeastRise = 0.02;    // grey; what rises less is no echo
constexpr int kReach = 16;             // samples to either side
constexpr float kStep = 0.5f;          // smallest spacings between samples
constexpr std::size_t kMost = 16'384;  // points; more do not change the average
constexpr std::size_t kBatch = 256;

// From far outside (index 0) to far inside; kReach is the point itself.
using Profile = std::array<double, 2 * kReach + 1>;

// The grey along one normal.
void addProfile(const Volume<float>& volume, const glm::vec3& position, const glm::vec3& normal,
                Profile& sum) {
  const Geometry& g = volume.geometry;
  const glm::vec3 start(g.toIndex(glm::dvec3(position)));
  const glm::vec3 inward = glm::vec3(glm::transpose(g.direction) * glm::dvec3(-normal)) *
                           (kStep * float(g.minSpacing())) / glm::vec3(g.spacing);
  for (int s = -kReach; s <= kReach; ++s)
    sum[std::size_t(s + kReach)] += double(sampleTrilinear(volume, start + float(s) * inward));
}

Profile meanProfile(const SurfacePoints& points, const Volume<float>& volume, const Progress& progress) {
  const std::size_t stride = (points.size() + kMost - 1) / kMost,
                    count = (points.size() + stride - 1) / stride;
  std::vector<Profile> sums((count + kBatch - 1) / kBatch, Profile{});
  parallelFor(
      std::ptrdiff_t(sums.size()),
      [&](std::ptrdiff_t batch) {
        const std::size_t first = std::size_t(batch) * kBatch;
        for (std::size_t n = first; n < std::min(count, first + kBatch); ++n)
          addProfile(volume, points.positions[n * stride], points.normals[n * stride],
                     sums[std::size_t(batch)]);
      },
      progress);
  Profile mean{};
  for (const Profile& sum : sums)
    for (std::size_t s = 0; s < mean.size(); ++s) mean[s] += sum[s] / double(count);
  return mean;
}

}  // namespace

double echoOffset(const SurfacePoints& points, const Volume<float>& volume, const Progress& progress) {
  if (points.size() == 0) return 0;
  const Profile grey = meanProfile(points, volume, progress);
  const auto point = grey.begin() + kReach;
  const double outside = *std::min_element(grey.begin(), point);
  auto peak = point;
  while (peak + 1 != grey.end() && *(peak + 1) >= *peak) ++peak;
  if (*peak - outside < kLeastRise) return 0;
  const double level = outside + kSkinRise * (*peak - outside);
  // From the maximum outward: the last place that is below the level.
  auto below = peak;
  while (below != grey.begin() && *below >= level) --below;
  const double place = double(below - point) + (level - *below) / (*(below + 1) - *below);
  return place * double(kStep) * volume.geometry.minSpacing();
}

void moveInward(SurfacePoints& points, double mm) {
  for (std::size_t p = 0; p < points.size(); ++p) points.positions[p] -= float(mm) * points.normals[p];
}

}  // namespace sonoskin
