#include "core/rbf/compact/coverage.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel_blocks.h"
#include "core/rbf/basis.h"
#include "core/rbf/lane_packer.h"

namespace sonoskin {
namespace {

constexpr std::size_t kCentresPerTask = 32, kPointsPerTask = 8192;

// The points closer than a centre's support: number and squared distance.
struct Covered {
  std::vector<std::uint32_t> point;
  std::vector<float> squared;
  std::size_t count = 0;

  void find(const SortedPoints& points, const Centre& centre) {
    count = 0;
    points.grid.forEachRun(centre.position, centre.support, [&](std::size_t first, std::size_t last) {
      if (point.size() < count + (last - first) + LanePacker::kLanes) {
        point.resize(2 * (count + last - first) + LanePacker::kLanes);
        squared.resize(point.size());
      }
      addRun(points, centre, first, last);
    });
  }

 private:
  void addRun(const SortedPoints& points, const Centre& centre, std::size_t first, std::size_t last) {
    const __m256i lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    const __m256 limit = _mm256_set1_ps(centre.support * centre.support);
    for (std::size_t i = first; i < last; i += LanePacker::kLanes) {
      const __m256i valid = LanePacker::firstLanes(last - i);
      const __m256 x = _mm256_maskload_ps(&points.x[i], valid) - centre.position.x;
      const __m256 y = _mm256_maskload_ps(&points.y[i], valid) - centre.position.y;
      const __m256 z = _mm256_maskload_ps(&points.z[i], valid) - centre.position.z;
      const __m256 distance = x * x + y * y + z * z;
      const __m256 isNear = _mm256_cmp_ps(distance, limit, _CMP_LT_OQ);
      const LanePacker packer(
          unsigned(_mm256_movemask_ps(_mm256_and_ps(isNear, _mm256_castsi256_ps(valid)))));
      packer.pack(distance, &squared[count]);
      packer.pack(_mm256_add_epi32(_mm256_set1_epi32(int(i)), lane), &point[count]);
      count += packer.count();
    }
  }
};

// Rows of a few centres, one after the other.
struct Part {
  std::vector<std::size_t> length;
  std::vector<CoverageEntry> entries;
};

Part coverPart(const SortedPoints& points, const std::vector<Centre>& centres, std::size_t first,
               std::size_t last) {
  thread_local Covered covered;
  Part part;
  for (std::size_t i = first; i < last; ++i) {
    covered.find(points, centres[i]);
    const std::size_t before = part.entries.size();
    part.entries.resize(before + covered.count);
    CoverageEntry* out = part.entries.data() + before;
    const float inverse = 1 / centres[i].support;
    std::size_t n = 0;
    for (std::size_t j = 0; j < covered.count; ++j) {
      out[n] = {covered.point[j], wendland(std::sqrt(covered.squared[j]) * inverse)};
      n += out[n].phi > 0;  // rounding may give 0 at the very border
    }
    part.entries.resize(before + n);
    part.length.push_back(n);
  }
  return part;
}

// The part of a row that lies among points [first, last).
template <class F>
void forEachBetween(const CoverageRows& rows, std::size_t row, std::size_t first, std::size_t last, F&& f) {
  const CoverageEntry *begin = rows.begin(row), *end = rows.end(row);
  if (begin == end || begin->other >= last || (end - 1)->other < first) return;
  const auto isBefore = [](const CoverageEntry& e, std::size_t point) { return e.other < point; };
  for (const CoverageEntry* e = std::lower_bound(begin, end, first, isBefore); e < end && e->other < last;
       ++e)
    f(*e);
}

}  // namespace

CoverageRows coverageByCentre(const SortedPoints& points, const std::vector<Centre>& centres,
                              const Progress& progress) {
  std::vector<Part> parts(blockCount(centres.size(), kCentresPerTask));
  parallelBlocks(
      centres.size(), kCentresPerTask,
      [&](std::size_t first, std::size_t end) {
        parts[first / kCentresPerTask] = coverPart(points, centres, first, end);
      },
      progress);
  CoverageRows result;
  for (const Part& part : parts)
    for (const std::size_t length : part.length) result.start.push_back(result.start.back() + length);
  result.entries.resize(result.start.back());
  parallelBlocks(centres.size(), kCentresPerTask, [&](std::size_t first, std::size_t) {
    Part& part = parts[first / kCentresPerTask];
    std::copy(part.entries.begin(), part.entries.end(), result.begin(first));
    part = {};
  });
  return result;
}

CoverageRows coverageByPoint(const CoverageRows& byCentre, std::size_t points, const Progress& progress) {
  CoverageRows result;
  result.start.assign(points + 1, 0);
  // Every task owns a range of points, so that the order within a row is that of the centres.
  const auto forEachEntry = [&](const Progress& part, const auto& f) {
    parallelBlocks(
        points, kPointsPerTask,
        [&](std::size_t first, std::size_t end) {
          for (std::size_t c = 0; c < byCentre.rows(); ++c)
            forEachBetween(byCentre, c, first, end, [&](const CoverageEntry& e) { f(c, e); });
        },
        part);
  };
  forEachEntry(progress.part(0, 0.5),
               [&](std::size_t, const CoverageEntry& e) { ++result.start[e.other + 1]; });
  for (std::size_t k = 0; k < points; ++k) result.start[k + 1] += result.start[k];
  result.entries.resize(result.start.back());
  std::vector<std::size_t> next(result.start.begin(), result.start.end() - 1);
  forEachEntry(progress.part(0.5, 1), [&](std::size_t c, const CoverageEntry& e) {
    result.entries[next[e.other]++] = {std::uint32_t(c), e.phi};
  });
  return result;
}

}  // namespace sonoskin
