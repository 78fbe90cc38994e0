#include "core/volume/field_of_view.h"

extern "C" {
#include <libqhull_r/libqhull_r.h>
}

#include <memory>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

// A side plane leans back by the opening of the sector, 45 degrees at most; what leans back more is anatomy.
constexpr float kFacesProbe = -0.75f;

// The first and last non-zero voxel of every row, as index .* spacing.
std::vector<glm::dvec3> rowEnds(const Volume<float>& volume, const Progress& progress) {
  const Geometry& g = volume.geometry;
  std::vector<std::vector<glm::dvec3>> perSlice(std::size_t(g.dims.z));
  parallelFor(
      g.dims.z,
      [&](std::ptrdiff_t k) {
        for (int j = 0; j < g.dims.y; ++j) {
          const float* row = &volume.at(0, j, int(k));
          int first = 0, last = g.dims.x - 1;
          while (first < g.dims.x && row[first] <= 0) ++first;
          if (first == g.dims.x) continue;
          while (row[last] <= 0) --last;
          for (const int i : {first, last})
            perSlice[std::size_t(k)].push_back(glm::dvec3(i, j, double(k)) * g.spacing);
        }
      },
      progress);
  std::vector<glm::dvec3> ends;
  for (const auto& slice : perSlice) ends.insert(ends.end(), slice.begin(), slice.end());
  return ends;
}

// The planes of the convex hull; none for points without volume.
std::vector<glm::vec4> hullPlanes(std::vector<glm::dvec3>& points) {
  if (points.size() < 4) return {};
  qhT state;
  qh_zero(&state, nullptr);
  const std::unique_ptr<FILE, int (*)(FILE*)> sink(std::fopen("/dev/null", "w"), std::fclose);
  char command[] = "qhull Pp";
  const int failed =
      qh_new_qhull(&state, 3, int(points.size()), &points[0].x, false, command, sink.get(), sink.get());
  std::vector<glm::vec4> planes;
  if (!failed)
    for (const facetT* f = state.facet_list; f && f->next; f = f->next)
      planes.emplace_back(f->normal[0], f->normal[1], f->normal[2], f->offset);
  qh_freeqhull(&state, qh_ALL);
  int left = 0, total = 0;
  qh_memfreeshort(&state, &left, &total);
  return planes;
}

}  // namespace

FieldOfView findFieldOfView(const Volume<float>& volume, const Beam& beam, const Progress& progress) {
  std::vector<glm::dvec3> ends = rowEnds(volume, progress);
  const glm::vec3 axis(glm::transpose(volume.geometry.direction) * beam.axis);
  FieldOfView result;
  for (const glm::vec4& plane : hullPlanes(ends))
    (glm::dot(glm::vec3(plane), axis) > kFacesProbe ? result.sides : result.front).push_back(plane);
  return result;
}

}  // namespace sonoskin
