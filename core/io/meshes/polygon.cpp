#include "core/io/meshes/polygon.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/mesh.h"

namespace sonoskin {
namespace {

constexpr std::size_t kMostCut = 1000;

std::vector<Triangle> fan(std::span<const std::uint32_t> loop) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 2; i < loop.size(); ++i) triangles.push_back({loop[0], loop[i - 1], loop[i]});
  return triangles;
}

// The corners in a plane that sees the face counter-clockwise.
std::vector<glm::dvec2> flattened(std::span<const glm::vec3> corners) {
  glm::dvec3 normal(0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 a(corners[i] - corners[0]), b(corners[(i + 1) % corners.size()] - corners[0]);
    normal += glm::cross(a, b);
  }
  const glm::dvec3 size = glm::abs(normal);
  const int drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
  const int u = (drop + 1) % 3, v = (drop + 2) % 3;
  const double sign = normal[drop] < 0 ? -1 : 1;
  std::vector<glm::dvec2> flat;
  for (const glm::vec3& c : corners) flat.emplace_back(sign * double(c[u]), double(c[v]));
  return flat;
}

double area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool isInside(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
}

bool isConvex(const std::vector<glm::dvec2>& flat) {
  const std::size_t n = flat.size();
  for (std::size_t i = 0; i < n; ++i)
    if (area(flat[i], flat[(i + 1) % n], flat[(i + 2) % n]) < 0) return false;
  return true;
}

// Whether corner i of the loop can be cut off: it points outward, and no other lies in its triangle.
bool isEar(const std::vector<glm::dvec2>& flat, const std::vector<std::uint32_t>& loop, std::size_t i) {
  const std::size_t n = loop.size();
  const std::uint32_t before = loop[(i + n - 1) % n], after = loop[(i + 1) % n];
  const glm::dvec2 &a = flat[before], &b = flat[loop[i]], &c = flat[after];
  if (area(a, b, c) <= 0) return false;
  return std::ranges::none_of(loop, [&](std::uint32_t v) {
    return v != before && v != loop[i] && v != after && isInside(flat[v], a, b, c);
  });
}

std::vector<Triangle> cutEars(const std::vector<glm::dvec2>& flat, std::vector<std::uint32_t> loop) {
  std::vector<Triangle> triangles;
  std::size_t i = 0;
  while (loop.size() > 3) {
    const std::size_t n = loop.size();
    std::size_t tried = 0;
    for (; tried < n && !isEar(flat, loop, i); ++tried) i = (i + 1) % n;
    if (tried == n) break;
    triangles.push_back({loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n]});
    loop.erase(loop.begin() + std::ptrdiff_t(i));
    // Goes on at the corner before: it and the one after are the likeliest to have become ears.
    i = (i + n - 2) % (n - 1);
  }
  const std::vector<Triangle> rest = fan(loop);
  triangles.insert(triangles.end(), rest.begin(), rest.end());
  return triangles;
}

}  // namespace

std::vector<Triangle> splitPolygon(std::span<const glm::vec3> corners) {
  std::vector<std::uint32_t> loop(corners.size());
  for (std::size_t i = 0; i < loop.size(); ++i) loop[i] = std::uint32_t(i);
  if (loop.size() <= 3 || loop.size() > kMostCut) return fan(loop);
  const std::vector<glm::dvec2> flat = flattened(corners);
  return isConvex(flat) ? fan(loop) : cutEars(flat, std::move(loop));
}

}  // namespace sonoskin
