#include "core/rbf/global/global_sites.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace sonoskin {
namespace {

using Iterator = std::vector<std::uint32_t>::iterator;

int longestSide(const Sites& sites, Iterator first, Iterator last) {
  glm::dvec3 low = sites[*first], high = low;
  for (Iterator i = first; i != last; ++i) {
    low = glm::min(low, sites[*i]);
    high = glm::max(high, sites[*i]);
  }
  const glm::dvec3 extent = high - low;
  return extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
}

void split(const Sites& sites, std::size_t most, std::size_t first, std::size_t last, SiteLeaves& leaves) {
  if (last - first <= most) {
    leaves.begin.push_back(last);
    return;
  }
  const auto at = [&](std::size_t i) { return leaves.order.begin() + std::ptrdiff_t(i); };
  const std::array<const std::vector<double>*, 3> axes{&sites.x, &sites.y, &sites.z};
  const std::vector<double>& along = *axes[std::size_t(longestSide(sites, at(first), at(last)))];
  const std::size_t middle = (first + last) / 2;
  // Ties by index, so that the order is the same with every library.
  std::nth_element(at(first), at(middle), at(last), [&](std::uint32_t a, std::uint32_t b) {
    return along[a] < along[b] || (along[a] == along[b] && a < b);
  });
  split(sites, most, first, middle, leaves);
  split(sites, most, middle, last, leaves);
}

}  // namespace

Sites pick(const Sites& sites, const std::vector<std::uint32_t>& indices) {
  Sites result;
  for (const std::uint32_t i : indices) result.push_back(sites[i]);
  return result;
}

UnitFrame unitFrame(const Sites& positions) {
  const auto middle = [](const std::vector<double>& v) {
    const auto [low, high] = std::minmax_element(v.begin(), v.end());
    return std::pair{0.5 * (*low + *high), 0.5 * (*high - *low)};
  };
  const auto [cx, hx] = middle(positions.x);
  const auto [cy, hy] = middle(positions.y);
  const auto [cz, hz] = middle(positions.z);
  return {{cx, cy, cz}, std::max({hx, hy, hz})};
}

Sites toUnit(const UnitFrame& frame, const Sites& positions) {
  Sites result;
  for (std::size_t i = 0; i < positions.size(); ++i) result.push_back(frame.toUnit(positions[i]));
  return result;
}

SiteLeaves splitIntoLeaves(const Sites& sites, std::size_t most) {
  SiteLeaves leaves;
  leaves.order.resize(sites.size());
  std::iota(leaves.order.begin(), leaves.order.end(), 0u);
  leaves.begin.push_back(0);
  split(sites, most, 0, sites.size(), leaves);
  return leaves;
}

}  // namespace sonoskin
