#include "core/io/loaded_mesh.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/mesh/facts/mesh_doubts.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

bool isFinite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool isUnit(const glm::vec3& v) { return std::abs(glm::length(v) - 1) < 1e-3f; }

bool isShare(float v) { return v >= 0 && v <= 1; }

bool haveFiniteCorners(const Mesh& mesh) {
  return std::ranges::all_of(mesh.cornerUvs, [](const std::array<glm::vec2, 3>& corners) {
    return std::ranges::all_of(
        corners, [](const glm::vec2& uv) { return std::isfinite(uv.x) && std::isfinite(uv.y); });
  });
}

void cutToShares(std::vector<float>& values) {
  for (float& v : values) v = v > 0 ? std::min(v, 1.f) : 0;  // what is no number is not above 0
}

// Lists of one entry for each position, or empty.
bool haveSoundLists(const Mesh& m) {
  const std::size_t n = m.positions.size();
  const auto fits = [&](std::size_t size) { return size == 0 || size == n; };
  return fits(m.normals.size()) && fits(m.visibility.size()) && fits(m.measured.size()) &&
         fits(m.labels.size()) && (m.cornerUvs.empty() || m.cornerUvs.size() == m.triangles.size()) &&
         std::ranges::all_of(m.normals, isUnit) && std::ranges::all_of(m.visibility, isShare) &&
         std::ranges::all_of(m.measured, isShare) && haveFiniteCorners(m);
}

}  // namespace

void settleMesh(Mesh& mesh) {
  for (glm::vec3& n : mesh.normals)
    if (!isUnit(n)) n = glm::normalize(n);  // the others stay as they are, bit by bit
  if (mesh.normals.empty() || !std::ranges::all_of(mesh.normals, isUnit)) computeNormals(mesh);
  cutToShares(mesh.visibility);
  cutToShares(mesh.measured);
  if (!haveFiniteCorners(mesh)) mesh.cornerUvs.clear();
}

void checkMesh(const Mesh& mesh, const fs::path& path) {
  require(!mesh.empty(), "{} holds no triangles; choose a file with a surface.", path.string());
  const std::size_t n = mesh.positions.size();
  require(std::ranges::all_of(mesh.positions, isFinite) &&
              std::ranges::all_of(mesh.triangles,
                                  [&](const Triangle& t) {
                                    return std::max({t[0], t[1], t[2]}) < n;
                                  }),
          "{} has triangles without vertices, or vertices at no finite place; get a fresh copy.",
          path.string());
  requireExtent(mesh, path.string());
  require(haveSoundLists(mesh),
          "{} gave numbers that contradict each other: it is damaged; get a fresh copy.", path.string());
}

}  // namespace sonoskin
