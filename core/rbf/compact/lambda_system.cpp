#include "core/rbf/compact/lambda_system.h"

#include <algorithm>
#include <numeric>

#include "core/base/parallel_blocks.h"

namespace sonoskin {
namespace {

constexpr std::size_t kPointsPerBlock = 32, kPointsPerTask = 4096;
constexpr std::size_t kSmallestTask = 32, kMostTasks = 256;  // rows; every task zeroes an array as long as λ
constexpr std::size_t kLanes = 8;

struct MatrixEntry {
  std::uint32_t row, column;
  float value;
};

// What the points of one task add to the upper half of A and to b.
struct Part {
  std::vector<MatrixEntry> entries;  // by row, and within it in the order of the points
  std::vector<std::pair<std::uint32_t, double>> b;
};

// The sums over a few neighbouring points.
class Block {
 public:
  explicit Block(std::size_t centres) : slotOf_(centres, kNone) {}

  void add(const SortedPoints& points, const CoverageRows& byPoint, const std::vector<float>& base,
           std::size_t first, std::size_t last, Part& part) {
    collectCentres(byPoint, first, last);
    const std::size_t stride = (centres_.size() + kLanes - 1) / kLanes * kLanes;
    matrix_.assign(centres_.size() * stride, 0);
    right_.assign(centres_.size(), 0);
    ph_.assign(stride, 0);
    for (std::size_t k = first; k < last; ++k) {
      const CoverageEntry *begin = byPoint.begin(k), *end = byPoint.end(k);
      for (const CoverageEntry* e = begin; e < end; ++e) ph_[slotOf_[e->other]] = e->phi;
      for (const CoverageEntry* e = begin; e < end; ++e)
        addRow(slotOf_[e->other], stride, points.influence[k] * e->phi, double(base[k]));
      for (const CoverageEntry* e = begin; e < end; ++e) ph_[slotOf_[e->other]] = 0;
    }
    emit(stride, part);
    for (const std::uint32_t c : centres_) slotOf_[c] = kNone;
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  void collectCentres(const CoverageRows& byPoint, std::size_t first, std::size_t last) {
    centres_.clear();
    for (const CoverageEntry* e = byPoint.begin(first); e < byPoint.begin(last); ++e)
      if (slotOf_[e->other] == kNone) {
        slotOf_[e->other] = 0;
        centres_.push_back(e->other);
      }
    std::sort(centres_.begin(), centres_.end());
    for (std::uint32_t s = 0; s < centres_.size(); ++s) slotOf_[centres_[s]] = s;
  }

  // Whole groups of lanes from the one that holds the diagonal on.
  void addRow(std::size_t slot, std::size_t stride, float weight, double base) {
    float* row = matrix_.data() + slot * stride;
    const float* ph = ph_.data();
#pragma omp simd
    for (std::size_t j = slot / kLanes * kLanes; j < stride; ++j) row[j] += weight * ph[j];
    right_[slot] -= double(weight) * base;
  }

  void emit(std::size_t stride, Part& part) const {
    for (std::size_t i = 0; i < centres_.size(); ++i) {
      part.b.emplace_back(centres_[i], right_[i]);
      for (std::size_t j = i; j < centres_.size(); ++j)
        if (const float value = matrix_[i * stride + j]; value != 0)
          part.entries.push_back({centres_[i], centres_[j], value});
    }
  }

  std::vector<std::uint32_t> slotOf_, centres_;  // of a centre; of a slot, ascending
  std::vector<float> matrix_, ph_;
  std::vector<double> right_;
};

// The upper half of one row of A.
using Row = std::vector<std::pair<std::uint32_t, double>>;

// Adds up entries of one row. `dense` holds one zero per centre and is left so.
class RowSum {
 public:
  explicit RowSum(std::size_t centres) : dense_(centres, 0) {}
  void add(std::uint32_t column, double value) {
    if (dense_[column] == 0) columns_.push_back(column);
    dense_[column] += value;
  }
  Row take() {
    std::sort(columns_.begin(), columns_.end());
    Row row;
    for (const std::uint32_t c : columns_) {
      row.emplace_back(c, dense_[c]);
      dense_[c] = 0;
    }
    columns_.clear();
    return row;
  }

 private:
  std::vector<double> dense_;
  std::vector<std::uint32_t> columns_;
};

// Keeps the order within a row.
void sortByRow(std::vector<MatrixEntry>& entries, std::size_t rows) {
  std::vector<std::uint32_t> next(rows + 1, 0);
  for (const MatrixEntry& e : entries) ++next[e.row + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<MatrixEntry> sorted(entries.size());
  for (const MatrixEntry& e : entries) sorted[next[e.row]++] = e;
  entries = std::move(sorted);
}

std::vector<Part> sumBlocks(const SortedPoints& points, const CoverageRows& byPoint,
                            const std::vector<float>& base, std::size_t centres, const Progress& progress) {
  std::vector<Part> parts(blockCount(points.size(), kPointsPerTask));
  parallelBlocks(
      points.size(), kPointsPerTask,
      [&](std::size_t start, std::size_t end) {
        Part& part = parts[start / kPointsPerTask];
        Block block(centres);
        for (std::size_t first = start; first < end; first += kPointsPerBlock)
          block.add(points, byPoint, base, first, std::min(end, first + kPointsPerBlock), part);
        sortByRow(part.entries, centres);
      },
      progress);
  return parts;
}

std::vector<Row> sumRows(const std::vector<Part>& parts, std::size_t centres, const Progress& progress) {
  std::vector<Row> rows(centres);
  parallelBlocks(
      centres, std::max(kSmallestTask, centres / kMostTasks),
      [&](std::size_t begin, std::size_t end) {
        RowSum sum(centres);
        const auto first = std::uint32_t(begin), last = std::uint32_t(end);
        const auto isBefore = [](const MatrixEntry& e, std::uint32_t row) { return e.row < row; };
        std::vector<const MatrixEntry*> at;
        for (const Part& part : parts)
          at.push_back(std::lower_bound(part.entries.data(), part.entries.data() + part.entries.size(), first,
                                        isBefore));
        for (std::uint32_t row = first; row < last; ++row) {
          for (std::size_t p = 0; p < parts.size(); ++p) {
            const MatrixEntry* partEnd = parts[p].entries.data() + parts[p].entries.size();
            for (; at[p] < partEnd && at[p]->row == row; ++at[p])
              sum.add(at[p]->column, double(at[p]->value));
          }
          rows[row] = sum.take();
        }
      },
      progress);
  return rows;
}

// Both halves of the matrix.
LambdaSystem mirror(const std::vector<Row>& rows) {
  LambdaSystem system;
  system.rowStart.assign(rows.size() + 1, 0);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& [column, value] : rows[i]) {
      ++system.rowStart[i + 1];
      if (column != i) ++system.rowStart[column + 1];
    }
  std::partial_sum(system.rowStart.begin(), system.rowStart.end(), system.rowStart.begin());
  system.column.resize(system.rowStart.back());
  system.value.resize(system.rowStart.back());
  std::vector<std::size_t> next(system.rowStart.begin(), system.rowStart.end() - 1);
  const auto add = [&](std::size_t row, std::size_t column, double value) {
    system.column[next[row]] = std::uint32_t(column);
    system.value[next[row]++] = value;
  };
  // Rows come in ascending order, so that a row's mirrored columns, which lie below its diagonal, come first.
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& [column, value] : rows[i]) {
      add(i, column, value);
      if (column != i) add(column, i, value);
    }
  return system;
}

}  // namespace

LambdaSystem sumLambdaSystem(const SortedPoints& points, const CoverageRows& byPoint,
                             const std::vector<float>& base, std::size_t centres, const Progress& progress) {
  const std::vector<Part> parts = sumBlocks(points, byPoint, base, centres, progress.part(0, 0.7));
  LambdaSystem system = mirror(sumRows(parts, centres, progress.part(0.7, 1)));
  system.b.assign(centres, 0);
  for (const Part& part : parts)
    for (const auto& [row, value] : part.b) system.b[row] += value;
  const double total = std::accumulate(points.influence.begin(), points.influence.end(), 0.0);
  const double scale = 1 / (points.diagonal * points.diagonal * total);
  for (double& value : system.value) value *= scale;
  for (double& value : system.b) value *= scale;
  return system;
}

}  // namespace sonoskin
