#include "core/mesh/view_shares.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/perpendicular.h"

namespace sonoskin {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

// Where a point lies among the beams: across them, relative to the middle beam, and along them.
struct BeamPlace {
  glm::dvec2 across{0};  // radians around an apex (equidistant from the middle beam), mm for parallel beams
  double depth = 0;      // mm
};

class BeamFrame {
 public:
  BeamFrame(const Beam& beam, const glm::dvec3& middle)
      : apex_(beam.apex), origin_(beam.apex.value_or(middle)), forward_(beam.directionAt(middle)) {
    right_ = perpendicularTo<0, 1>(forward_);
    up_ = glm::cross(right_, forward_);
  }
  BeamPlace place(const glm::vec3& world) const {
    const glm::dvec3 d = glm::dvec3(world) - origin_;
    const glm::dvec2 lateral(glm::dot(d, right_), glm::dot(d, up_));
    if (!apex_) return {lateral, glm::dot(d, forward_)};
    const double off = glm::length(lateral);
    const double angle = std::atan2(off, glm::dot(d, forward_));
    return {off > 0 ? lateral * (angle / off) : lateral, glm::length(d)};
  }

 private:
  std::optional<glm::dvec3> apex_;
  glm::dvec3 origin_, forward_, right_, up_;
};

// For each of a square of beams the part that it meets first.
class FirstHits {
 public:
  static constexpr int kBeams = 256;

  explicit FirstHits(double halfExtent)
      : scale_(kBeams / (2 * halfExtent)),
        part_(std::size_t(kBeams) * kBeams, kNone),
        depth_(std::size_t(kBeams) * kBeams, std::numeric_limits<double>::infinity()) {}

  // Fills the beams that a triangle crosses, by samples half a beam apart.
  void draw(std::uint32_t part, const BeamPlace& a, const BeamPlace& b, const BeamPlace& c) {
    const double edge = std::max({glm::distance(a.across, b.across), glm::distance(b.across, c.across),
                                  glm::distance(c.across, a.across)});
    const int steps = std::clamp(int(std::ceil(2 * edge * scale_)), 1, 2 * kBeams);
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        const double u = double(i) / steps, v = double(j) / steps, w = 1 - u - v;
        plot(part, w * a.across + u * b.across + v * c.across, w * a.depth + u * b.depth + v * c.depth);
      }
  }

  // Adds to each part the beams that it is the first on, and their weights.
  void addTo(std::vector<double>& centred, std::vector<double>& seen) const {
    constexpr double kWidth = 0.35;
    for (int y = 0; y < kBeams; ++y)
      for (int x = 0; x < kBeams; ++x) {
        const std::uint32_t part = part_[std::size_t(y) * kBeams + std::size_t(x)];
        if (part == kNone) continue;
        const glm::dvec2 off = (glm::dvec2(x, y) + 0.5) * (2.0 / kBeams) - 1.0;
        centred[part] += std::exp(-glm::dot(off, off) / (2 * kWidth * kWidth));
        seen[part] += 1;
      }
  }

 private:
  void plot(std::uint32_t part, const glm::dvec2& across, double depth) {
    const glm::ivec2 beam = glm::clamp(glm::ivec2(glm::floor(across * scale_)) + kBeams / 2, 0, kBeams - 1);
    const std::size_t i = std::size_t(beam.y) * kBeams + std::size_t(beam.x);
    if (depth >= depth_[i]) return;
    depth_[i] = depth;
    part_[i] = part;
  }

  double scale_;  // beams per unit across
  std::vector<std::uint32_t> part_;
  std::vector<double> depth_;
};

// As shares of the largest.
void normalise(std::vector<double>& scores) {
  const double best = scores.empty() ? 0 : *std::max_element(scores.begin(), scores.end());
  for (double& score : scores) score = best > 0 ? score / best : 1;
}

}  // namespace

ViewShares viewShares(const Mesh& mesh, const std::vector<std::uint32_t>& partOfTriangle, std::size_t parts,
                      const Beam& beam, const glm::dvec3& middle) {
  const BeamFrame frame(beam, middle);
  std::vector<BeamPlace> places;
  places.reserve(mesh.positions.size());
  double halfExtent = 1e-9;
  for (const glm::vec3& x : mesh.positions) {
    places.push_back(frame.place(x));
    halfExtent = std::max({halfExtent, std::abs(places.back().across.x), std::abs(places.back().across.y)});
  }
  FirstHits hits(halfExtent);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    hits.draw(partOfTriangle[i], places[t[0]], places[t[1]], places[t[2]]);
  }
  ViewShares shares{std::vector<double>(parts, 0), std::vector<double>(parts, 0)};
  hits.addTo(shares.centred, shares.seen);
  normalise(shares.centred);
  normalise(shares.seen);
  return shares;
}

}  // namespace sonoskin
