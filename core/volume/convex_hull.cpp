#include "core/volume/convex_hull.h"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

namespace sonoskin {
namespace {

// One hull by qhull: the state with everything that it holds.
class Quickhull {
 public:
  explicit Quickhull(std::vector<glm::dvec3>& points) {
    qh_zero(&state_, nullptr);
    const std::unique_ptr<FILE, int (*)(FILE*)> sink(std::fopen("/dev/null", "w"), std::fclose);
    char command[] = "qhull Pp";
    failed_ = qh_new_qhull(&state_, 3, int(points.size()), &points[0].x, false, command, sink.get(),
                           sink.get()) != 0;
  }
  ~Quickhull() {
    qh_freeqhull(&state_, qh_ALL);
    int left = 0, total = 0;
    qh_memfreeshort(&state_, &left, &total);
  }
  Quickhull(const Quickhull&) = delete;
  Quickhull& operator=(const Quickhull&) = delete;

  std::vector<HullFace> faces() {
    std::vector<HullFace> faces;
    if (failed_) return faces;
    for (facetT* f = state_.facet_list; f && f->next; f = f->next)
      faces.push_back({{f->normal[0], f->normal[1], f->normal[2]}, f->offset, qh_facetarea(&state_, f)});
    return faces;
  }
  std::vector<glm::dvec3> corners() const {
    std::vector<glm::dvec3> corners;
    if (failed_) return corners;
    for (const vertexT* v = state_.vertex_list; v && v->next; v = v->next)
      corners.emplace_back(v->point[0], v->point[1], v->point[2]);
    return corners;
  }

 private:
  qhT state_;
  bool failed_ = true;
};

// The offset of the plane or line across `normal` that touches the body from outside.
template <class Vector>
double touching(const std::vector<Vector>& corners, const Vector& normal) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Vector& corner : corners) most = std::max(most, glm::dot(corner, normal));
  return -most;
}

double& sizeOf(HullFace& face) { return face.area; }
double& sizeOf(HullEdge& edge) { return edge.length; }

// Joins faces (or edges) of nearly the same direction, the largest first.
template <class Face, class Vector>
std::vector<Face> mergeFaces(std::vector<Face> faces, const std::vector<Vector>& corners, double merging) {
  std::stable_sort(faces.begin(), faces.end(), [](Face a, Face b) { return sizeOf(a) > sizeOf(b); });
  const double near = std::cos(merging);
  std::vector<Face> merged;
  std::vector<Vector> sums;  // of the normals, weighted by size
  for (Face& face : faces) {
    std::size_t m = 0;
    while (m < merged.size() && glm::dot(merged[m].normal, face.normal) < near) ++m;
    if (m == merged.size()) {
      merged.push_back(face);
      sums.push_back(face.normal * sizeOf(face));
    } else {
      sizeOf(merged[m]) += sizeOf(face);
      sums[m] += face.normal * sizeOf(face);
    }
  }
  for (std::size_t m = 0; m < merged.size(); ++m) {
    merged[m].normal = glm::normalize(sums[m]);
    merged[m].offset = touching(corners, merged[m].normal);
  }
  std::stable_sort(merged.begin(), merged.end(), [](Face a, Face b) { return sizeOf(a) > sizeOf(b); });
  return merged;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// The corners of the outline, counter-clockwise (monotone chain) [Andrew 1979].
std::vector<glm::dvec2> outlineCorners(std::vector<glm::dvec2>& points) {
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<glm::dvec2> corners;
  const auto add = [&](const glm::dvec2& p, std::size_t fixed) {
    while (corners.size() > fixed + 1 &&
           cross(corners.back() - corners[corners.size() - 2], p - corners.back()) <= 0)
      corners.pop_back();
    corners.push_back(p);
  };
  for (const glm::dvec2& p : points) add(p, 0);
  const std::size_t lower = corners.size() - 1;
  for (std::size_t n = points.size() - 1; n-- > 0;) add(points[n], lower);
  corners.pop_back();
  return corners;
}

}  // namespace

std::vector<HullFace> convexHull(std::vector<glm::dvec3> points, double merging) {
  if (points.size() < 4) return {};
  Quickhull hull(points);
  return mergeFaces(hull.faces(), hull.corners(), merging);
}

std::vector<HullEdge> convexOutline(std::vector<glm::dvec2> points, double merging) {
  if (points.size() < 3) return {};
  const std::vector<glm::dvec2> corners = outlineCorners(points);
  if (corners.size() < 3) return {};
  std::vector<HullEdge> edges;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const glm::dvec2 along = corners[(c + 1) % corners.size()] - corners[c];
    const double length = glm::length(along);
    const glm::dvec2 normal(along.y / length, -along.x / length);
    edges.push_back({normal, -glm::dot(normal, corners[c]), length});
  }
  return mergeFaces(std::move(edges), corners, merging);
}

}  // namespace sonoskin
