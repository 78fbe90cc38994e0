#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace sonoskin {

// DisjointSets: items 0 to count - 1, each in a set of its own until sets are joined. One item of a set, its root,
// stands for it.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t root(std::uint32_t item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }
  bool isRoot(std::uint32_t item) const { return parent_[item] == item; }

  // join: the smaller root stands for both sets, so that it is the first item of its set.
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a), b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  // joinInto: the root of `into` stands for both sets.
  void joinInto(std::uint32_t item, std::uint32_t into) { parent_[root(item)] = root(into); }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace sonoskin
