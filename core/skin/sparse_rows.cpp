#include "core/skin/sparse_rows.h"

#include <algorithm>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

constexpr std::size_t kRowsPerTask = 1024;

std::size_t tasksOf(std::size_t rows) { return (rows + kRowsPerTask - 1) / kRowsPerTask; }

// Calls f(row) for the rows of a task.
template <class F>
void forEachRow(std::ptrdiff_t task, std::size_t rows, F&& f) {
  const std::size_t first = std::size_t(task) * kRowsPerTask;
  for (std::size_t row = first; row < std::min(first + kRowsPerTask, rows); ++row) f(row);
}

}  // namespace

SparseRows makeRows(std::size_t rows,
                    const std::function<void(std::size_t row, std::vector<SparseRows::Link>&)>& fill,
                    const Progress& progress) {
  SparseRows result;
  result.start.resize(rows + 1);
  std::vector<std::vector<SparseRows::Link>> parts(tasksOf(rows));
  parallelFor(
      std::ptrdiff_t(parts.size()),
      [&](std::ptrdiff_t task) {
        std::vector<SparseRows::Link>& part = parts[std::size_t(task)];
        forEachRow(task, rows, [&](std::size_t row) {
          const std::size_t before = part.size();
          fill(row, part);
          result.start[row + 1] = std::uint32_t(part.size() - before);
        });
      },
      progress);
  for (std::size_t row = 0; row < rows; ++row) result.start[row + 1] += result.start[row];
  result.links.resize(result.start.back());
  parallelFor(std::ptrdiff_t(parts.size()), [&](std::ptrdiff_t task) {
    const std::size_t first = std::size_t(task) * kRowsPerTask;
    std::copy(parts[std::size_t(task)].begin(), parts[std::size_t(task)].end(),
              result.links.begin() + result.start[first]);
  });
  return result;
}

std::vector<glm::vec4> multiply(const SparseRows& rows, std::span<const glm::vec4> source) {
  std::vector<glm::vec4> result(rows.rows());
  parallelFor(std::ptrdiff_t(tasksOf(rows.rows())), [&](std::ptrdiff_t task) {
    forEachRow(task, rows.rows(), [&](std::size_t row) {
      glm::vec4 sum(0);
      for (std::uint32_t i = rows.start[row]; i < rows.start[row + 1]; ++i)
        sum += rows.links[i].weight * source[rows.links[i].source];
      result[row] = sum;
    });
  });
  return result;
}

}  // namespace sonoskin
