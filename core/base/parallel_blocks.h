#pragma once

#include <algorithm>
#include <cstddef>

#include "core/base/parallel.h"

namespace sonoskin {

// blockCount: blocks of `size` items that hold `count` items, the last one perhaps with fewer.
constexpr std::size_t blockCount(std::size_t count, std::size_t size) { return (count + size - 1) / size; }

// parallelBlocks: calls body(first, end) for the blocks of items [0, count), block number first / size, as parallelFor.
//   errors   the first exception thrown by a body; Cancelled, looked at before every block
template <class Body>
void parallelBlocks(std::size_t count, std::size_t size, const Body& body, const Progress& progress = {}) {
  parallelFor(
      std::ptrdiff_t(blockCount(count, size)),
      [&](std::ptrdiff_t block) {
        const std::size_t first = std::size_t(block) * size;
        body(first, std::min(first + size, count));
      },
      progress);
}

// parallelItems: calls body(i) once for every i in [0, count), `perTask` of them to a thread at a time: for items that
// are too little work for a call of parallelFor each.
//   errors   as parallelBlocks
template <class Body>
void parallelItems(std::size_t count, std::size_t perTask, const Body& body, const Progress& progress = {}) {
  parallelBlocks(
      count, perTask,
      [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) body(i);
      },
      progress);
}

}  // namespace sonoskin
