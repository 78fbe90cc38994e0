#include "core/volume/lasso.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

constexpr int kMostPixels = 8192;  // along a side of the outline's box; a screen has fewer

// Stencil: which pixels of the outline's box lie within it.
class Stencil {
 public:
  explicit Stencil(const std::vector<glm::dvec2>& outline) {
    if (outline.size() < 3) return;
    glm::dvec2 low(outline[0]), high(outline[0]);
    for (const glm::dvec2& p : outline) low = glm::min(low, p), high = glm::max(high, p);
    first_ = glm::floor(low);
    const glm::dvec2 extent = glm::ceil(high) - first_;
    if (!(extent.x >= 1 && extent.y >= 1 && extent.x <= kMostPixels && extent.y <= kMostPixels)) return;
    size_ = glm::ivec2(extent);
    inside_.assign(std::size_t(size_.x) * std::size_t(size_.y), 0);
    for (int y = 0; y < size_.y; ++y) fillRow(outline, y);
  }

  bool empty() const { return inside_.empty(); }
  bool contains(const glm::dvec2& pixel) const {
    const glm::dvec2 p = pixel - first_;
    if (!(p.x >= 0 && p.y >= 0 && p.x < size_.x && p.y < size_.y)) return false;
    return inside_[std::size_t(p.y) * std::size_t(size_.x) + std::size_t(p.x)] != 0;
  }

 private:
  // The pixels of a row between crossings of its middle that the outline goes round.
  void fillRow(const std::vector<glm::dvec2>& outline, int row) {
    const double y = first_.y + row + 0.5;
    std::vector<std::pair<double, int>> crossings;  // where, and whether the side goes down or up
    for (std::size_t n = 0; n < outline.size(); ++n) {
      const glm::dvec2 a = outline[n], b = outline[(n + 1) % outline.size()];
      if ((a.y <= y) == (b.y <= y)) continue;
      crossings.emplace_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), a.y < b.y ? 1 : -1);
    }
    std::ranges::sort(crossings);
    int rounds = 0;
    for (std::size_t n = 0; n + 1 < crossings.size(); ++n) {
      rounds += crossings[n].second;
      if (rounds == 0) continue;
      const auto at = [&](double x) { return std::clamp(int(std::ceil(x - first_.x - 0.5)), 0, size_.x); };
      std::uint8_t* begin = inside_.data() + std::size_t(row) * std::size_t(size_.x);
      std::fill(begin + at(crossings[n].first), begin + at(crossings[n + 1].first), std::uint8_t(1));
    }
  }

  glm::dvec2 first_{0};
  glm::ivec2 size_{0};
  std::vector<std::uint8_t> inside_;
};

// forVoxels: calls visit(k, voxel, depth) for what counts; slices at once on several threads.
template <class Visit>
void forVoxels(const Geometry& g, const Lasso& lasso, const Visit& visit) {
  const Stencil stencil(lasso.outline);
  if (stencil.empty()) return;
  const auto seen = [&](const glm::dvec3& index) {
    return lasso.toPicture * glm::dvec4(g.toWorld(index), 1);
  };
  const glm::dvec4 step = seen({1, 0, 0}) - seen({0, 0, 0});
  parallelFor(g.dims.z, [&](std::ptrdiff_t k) {
    for (int j = 0; j < g.dims.y; ++j) {
      const glm::dvec4 begin = seen({0, j, k});
      for (int i = 0; i < g.dims.x; ++i) {
        const glm::dvec4 p = begin + double(i) * step;
        if (!(p.w > 0) || p.z < lasso.from || p.z > lasso.to) continue;
        if (stencil.contains(glm::dvec2(p) / p.w) != lasso.outside) visit(k, g.index(i, j, int(k)), p.z);
      }
    }
  });
}

}  // namespace

VoxelRuns paint(Volume<std::uint8_t>& mask, const Lasso& lasso) {
  std::vector<VoxelRuns> changed(std::size_t(mask.geometry.dims.z));
  forVoxels(mask.geometry, lasso, [&](std::ptrdiff_t k, std::size_t voxel, double) {
    if ((mask.data[voxel] != 0) == lasso.mark) return;
    mask.data[voxel] = lasso.mark ? 1 : 0;
    append(changed[std::size_t(k)], voxel);
  });
  VoxelRuns all;
  for (const VoxelRuns& runs : changed) all.insert(all.end(), runs.begin(), runs.end());
  return all;
}

double nearestWithin(const Volume<float>& volume, double level, const Lasso& lasso) {
  std::vector<double> nearest(std::size_t(volume.geometry.dims.z), std::numeric_limits<double>::infinity());
  forVoxels(volume.geometry, lasso, [&](std::ptrdiff_t k, std::size_t voxel, double depth) {
    double& least = nearest[std::size_t(k)];
    if (double(volume.data[voxel]) >= level) least = std::min(least, depth);
  });
  return nearest.empty() ? std::numeric_limits<double>::infinity() : *std::ranges::min_element(nearest);
}

}  // namespace sonoskin
