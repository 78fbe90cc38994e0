#include "core/mesh/search/seen_triangles.h"

#include <atomic>
#include <limits>

#include "core/base/parallel_blocks.h"
#include "core/mesh/atlas/atlas_bands.h"

namespace sonoskin {
namespace {

constexpr std::size_t kPerTask = 1 << 14;  // vertices or triangles
constexpr std::uint32_t kNone = 0xffffffffu;

// In samples from the lower left corner; z: depth, smaller is nearer; w: not above 0 where a place cannot be drawn.
std::vector<glm::vec4> projected(const Mesh& mesh, const glm::mat4& viewProjection, const glm::vec2& size) {
  constexpr float kFarthest = 1e5f;  // samples aside: what is so near to the camera is not worth a look
  std::vector<glm::vec4> places(mesh.positions.size());
  parallelItems(places.size(), kPerTask, [&](std::size_t i) {
    const glm::vec4 clip = viewProjection * glm::vec4(mesh.positions[i], 1);
    const glm::vec3 p = glm::vec3(clip) / clip.w;
    const glm::vec2 at = 0.5f * (glm::vec2(p) + 1.f) * size;
    const bool drawn = clip.w > 0 && glm::all(glm::lessThan(glm::abs(at), glm::vec2(kFarthest)));
    places[i] = glm::vec4(at, p.z, drawn ? 1 : 0);
  });
  return places;
}

// Marks the triangles of a band of rows that are not hidden by what samples near them show.
class BandMarks {
 public:
  static constexpr int kMargin = 1;  // samples around a triangle that must all be nearer to hide it

  BandMarks(const Mesh& mesh, const std::vector<glm::vec4>& places, const std::vector<Corners>& corners,
            const glm::ivec2& size)
      : mesh_(mesh), places_(places), corners_(corners), size_(size) {}

  void mark(const AtlasBands& bands, int band, std::vector<std::uint8_t>& isSeen) const {
    const glm::ivec2 inner = bands.rows(band),
                     rows(std::max(inner[0] - kMargin, 0), std::min(inner[1] + kMargin, size_.y));
    thread_local std::vector<float> depth;
    depth.assign(std::size_t(rows[1] - rows[0]) * std::size_t(size_.x), std::numeric_limits<float>::max());
    for (const std::uint32_t* t = bands.begin(band); t != bands.end(band); ++t) {
      const glm::vec3 z = depthsOf(*t);
      forEachTexel(corners_[*t], size_.x, rows, [&](int x, int y, const glm::vec3& w) {
        float& nearest = depth[std::size_t(y - rows[0]) * std::size_t(size_.x) + std::size_t(x)];
        nearest = std::min(nearest, glm::dot(w, z));
      });
    }
    for (const std::uint32_t* t = bands.begin(band); t != bands.end(band); ++t) {
      std::atomic_ref seen(isSeen[*t]);  // a triangle may lie in two bands
      if (!seen.load(std::memory_order_relaxed) && !isHidden(*t, rows, depth))
        seen.store(1, std::memory_order_relaxed);
    }
  }

 private:
  glm::vec3 depthsOf(std::uint32_t t) const {
    const auto& [i, j, k] = mesh_.triangles[t];
    return {places_[i].z, places_[j].z, places_[k].z};
  }
  bool isHidden(std::uint32_t t, const glm::ivec2& rows, const std::vector<float>& depth) const {
    constexpr float kSame = 1e-5f;  // of the depth that there is: rounding
    const glm::vec3 z = depthsOf(t);
    const float nearest = std::min({z.x, z.y, z.z}) - kSame;
    const auto& [a, b, c] = corners_[t];
    const glm::ivec2 low(glm::floor(glm::min(a, glm::min(b, c)) - float(kMargin) + 0.5f)),
        high(glm::ceil(glm::max(a, glm::max(b, c)) + float(kMargin) - 0.5f));
    for (int y = std::max(low.y, rows[0]); y < std::min(high.y, rows[1]); ++y)
      for (int x = std::max(low.x, 0); x < std::min(high.x, size_.x); ++x)
        if (depth[std::size_t(y - rows[0]) * std::size_t(size_.x) + std::size_t(x)] >= nearest) return false;
    return true;
  }

  const Mesh& mesh_;
  const std::vector<glm::vec4>& places_;
  const std::vector<Corners>& corners_;
  glm::ivec2 size_;
};

float longest(const glm::vec3& v) { return std::max({v.x, v.y, v.z}); }

// CellMarks: marks on cubic cells of space.
class CellMarks {
 public:
  CellMarks(const Box& box, float cell) : low_(box.min) {
    constexpr float kMostCells = 160;  // along an axis
    cell_ = std::max({cell, longest(box.max - box.min) / kMostCells, 1e-6f});
    const glm::vec3 extent = box.max - box.min;
    dims_ = glm::ivec3(extent / cell_) + 1;
    marks_.assign(std::size_t(dims_.x) * std::size_t(dims_.y) * std::size_t(dims_.z), 0);
  }
  // forEach: calls f(mark) for the cells that a triangle's box meets.
  template <class F>
  void forEach(const Mesh& mesh, const Triangle& t, const F& f) {
    const glm::vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const glm::ivec3 low = at(glm::min(a, glm::min(b, c))), high = at(glm::max(a, glm::max(b, c)));
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) f(marks_[index({x, y, z})]);
  }
  // grow: marks with 2 what lies within `reach` of a cell that is marked with 1.
  void grow(float reach) {
    const int steps = int(std::ceil(reach / cell_));
    for (int z = 0; z < dims_.z; ++z)
      for (int y = 0; y < dims_.y; ++y)
        for (int x = 0; x < dims_.x; ++x)
          if (marks_[index({x, y, z})] == 1) growFrom({x, y, z}, steps, reach);
  }

 private:
  glm::ivec3 at(const glm::vec3& p) const {
    return glm::clamp(glm::ivec3((p - low_) / cell_), glm::ivec3(0), dims_ - 1);
  }
  std::size_t index(const glm::ivec3& c) const {
    return (std::size_t(c.z) * std::size_t(dims_.y) + std::size_t(c.y)) * std::size_t(dims_.x) +
           std::size_t(c.x);
  }
  void growFrom(const glm::ivec3& from, int steps, float reach) {
    const glm::ivec3 low = glm::max(from - steps, glm::ivec3(0)), high = glm::min(from + steps, dims_ - 1);
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y) {
        // What is left between the nearest sides of two cells.
        const glm::vec2 gap = cell_ * glm::max(glm::abs(glm::vec2(y - from.y, z - from.z)) - 1.f, 0.f);
        const float rest = reach * reach - glm::dot(gap, gap);
        if (rest < 0) continue;
        const int along = int(std::sqrt(rest) / cell_) + 1;
        for (int x = std::max(from.x - along, low.x); x <= std::min(from.x + along, high.x); ++x) {
          std::uint8_t& mark = marks_[index({x, y, z})];
          if (mark == 0) mark = 2;
        }
      }
  }

  glm::vec3 low_;
  float cell_;
  glm::ivec3 dims_;
  std::vector<std::uint8_t> marks_;
};

float longestSide(const Mesh& mesh) {
  float side = 0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const glm::vec3 &a = mesh.positions[i], &b = mesh.positions[j], &c = mesh.positions[k];
    side = std::max(side, longest(glm::max(a, glm::max(b, c)) - glm::min(a, glm::min(b, c))));
  }
  return side;
}

template <class T>
void keep(const std::vector<T>& values, const std::vector<std::uint32_t>& kept, std::vector<T>& to) {
  if (values.empty()) return;
  to.reserve(kept.size());
  for (const std::uint32_t i : kept) to.push_back(values[i]);
}

}  // namespace

std::vector<std::uint8_t> seenTriangles(const Mesh& mesh, const glm::mat4& viewProjection, glm::ivec2 size) {
  const std::vector<glm::vec4> places = projected(mesh, viewProjection, glm::vec2(size));
  std::vector<std::uint8_t> isSeen(mesh.triangles.size(), 0);
  constexpr Corners kNowhere{glm::vec2(-1e4f), glm::vec2(-1e4f), glm::vec2(-1e4f)};
  std::vector<Corners> corners(mesh.triangles.size(), kNowhere);
  parallelItems(corners.size(), kPerTask, [&](std::size_t t) {
    const auto& [i, j, k] = mesh.triangles[t];
    const glm::vec4 &a = places[i], &b = places[j], &c = places[k];
    if (a.w > 0 && b.w > 0 && c.w > 0)
      corners[t] = {glm::vec2(a), glm::vec2(b), glm::vec2(c)};
    else
      isSeen[t] = 1;
  });
  const AtlasBands bands(size, corners, BandMarks::kMargin + 1);
  const BandMarks marks(mesh, places, corners, size);
  parallelFor(bands.count(), [&](std::ptrdiff_t b) { marks.mark(bands, int(b), isSeen); });
  return isSeen;
}

std::vector<std::uint8_t> trianglesWithin(const Mesh& mesh, const std::vector<std::uint8_t>& isMarked,
                                          float reach) {
  // No triangle meets more than some cells.
  CellMarks cells(boundingBox(mesh.positions), std::max(reach, longestSide(mesh)) / 4);
  for (std::size_t t = 0; t < isMarked.size(); ++t)
    if (isMarked[t]) cells.forEach(mesh, mesh.triangles[t], [](std::uint8_t& mark) { mark = 1; });
  cells.grow(reach);
  std::vector<std::uint8_t> within(isMarked.size(), 0);
  for (std::size_t t = 0; t < within.size(); ++t)
    cells.forEach(mesh, mesh.triangles[t], [&](std::uint8_t mark) { within[t] |= mark > 0; });
  return within;
}

Mesh selectTriangles(const Mesh& mesh, const std::vector<std::uint32_t>& triangles) {
  Mesh part;
  std::vector<std::uint32_t> vertices, number(mesh.positions.size(), kNone);
  keep(mesh.triangles, triangles, part.triangles);
  keep(mesh.cornerUvs, triangles, part.cornerUvs);
  for (Triangle& t : part.triangles)
    for (std::uint32_t& v : t) {
      if (number[v] == kNone) {
        number[v] = std::uint32_t(vertices.size());
        vertices.push_back(v);
      }
      v = number[v];
    }
  keep(mesh.positions, vertices, part.positions);
  keep(mesh.normals, vertices, part.normals);
  keep(mesh.visibility, vertices, part.visibility);
  keep(mesh.measured, vertices, part.measured);
  keep(mesh.labels, vertices, part.labels);
  return part;
}

}  // namespace sonoskin
