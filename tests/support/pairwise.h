#pragma once

#include <cstdint>
#include <set>
#include <vector>

namespace sonoskin::test {

// pairwise: rows that hold every pair of values of any two choices at least once.
//   counts   how many values each choice has, >= 1; in a row they are numbered from 0
//   method   greedy: each row takes, choice after choice, the value with the most pairs that are new; a choice with the
//            most of them left goes first
inline std::vector<std::vector<int>> pairwise(const std::vector<int>& counts) {
  using Pair = std::pair<std::pair<std::size_t, int>, std::pair<std::size_t, int>>;
  std::set<Pair> left;
  for (std::size_t a = 0; a < counts.size(); ++a)
    for (std::size_t b = a + 1; b < counts.size(); ++b)
      for (int i = 0; i < counts[a]; ++i)
        for (int j = 0; j < counts[b]; ++j) left.insert({{a, i}, {b, j}});
  const auto isLeft = [&](std::size_t a, int i, std::size_t b, int j) {
    return left.contains(a < b ? Pair{{a, i}, {b, j}} : Pair{{b, j}, {a, i}});
  };
  std::vector<std::vector<int>> rows;
  while (!left.empty()) {
    const Pair first = *left.begin();
    std::vector<int> row(counts.size(), -1);
    row[first.first.first] = first.first.second;
    row[first.second.first] = first.second.second;
    for (std::size_t c = 0; c < counts.size(); ++c) {
      if (row[c] >= 0) continue;
      int best = 0, most = -1;
      for (int value = 0; value < counts[c]; ++value) {
        const int v = (value + int(rows.size())) % counts[c];  // ties fall to another value in every row
        int fresh = 0;
        for (std::size_t o = 0; o < counts.size(); ++o)
          fresh += o != c && row[o] >= 0 && isLeft(c, v, o, row[o]);
        if (fresh > most) most = fresh, best = v;
      }
      row[c] = best;
    }
    for (std::size_t a = 0; a < counts.size(); ++a)
      for (std::size_t b = a + 1; b < counts.size(); ++b) left.erase({{a, row[a]}, {b, row[b]}});
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace sonoskin::test
