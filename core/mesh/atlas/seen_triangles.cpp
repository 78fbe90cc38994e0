#include "core/mesh/atlas/seen_triangles.h"

#include <atomic>
#include <limits>

#include "core/base/parallel_blocks.h"
#include "core/mesh/atlas/atlas_bands.h"

namespace sonoskin {
namespace {

constexpr std::size_t kPerTask = 1 << 14;  // vertices or triangles

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

}  // namespace sonoskin
