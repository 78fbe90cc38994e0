#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/rbf/compact/centre_index.h"
#include "core/rbf/sorted_points.h"

namespace sonoskin {

// CoverageEntry: φ_i(p_k) > 0; `other` is the sorted point k in a centre's row, the centre i in a point's row.
struct CoverageEntry {
  std::uint32_t other;
  float phi;
};

// CoverageRows: a sparse matrix; `other` ascends within a row.
struct CoverageRows {
  std::vector<std::size_t> start{0};
  std::vector<CoverageEntry> entries;

  std::size_t rows() const { return start.size() - 1; }
  const CoverageEntry* begin(std::size_t row) const { return entries.data() + start[row]; }
  const CoverageEntry* end(std::size_t row) const { return entries.data() + start[row + 1]; }
  CoverageEntry* begin(std::size_t row) { return entries.data() + start[row]; }
  CoverageEntry* end(std::size_t row) { return entries.data() + start[row + 1]; }
};

// coverageByCentre: the points in every support. 14 to 16 entries per point.
//   errors   Cancelled
CoverageRows coverageByCentre(const SortedPoints& points, const std::vector<Centre>& centres,
                              const Progress& progress = {});

// coverageByPoint: the same by point: the supports over every point.
//   errors   Cancelled
CoverageRows coverageByPoint(const CoverageRows& byCentre, std::size_t points, const Progress& progress = {});

}  // namespace sonoskin
