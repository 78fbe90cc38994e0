#include "core/volume/field_of_view.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/volume/mask_depth.h"
#include "core/volume/sector_sides.h"

namespace sonoskin {
namespace {

// Faces whose directions differ by less are one. An arc of 130 mm is followed to 0.2 mm.
constexpr double kMerging = 0.05;  // rad

// The first and last voxel that is not zero of every row, in pairs, as index .* spacing.
template <class T>
std::vector<glm::dvec3> rowEnds(const Volume<T>& volume, const Progress& progress) {
  const Geometry& g = volume.geometry;
  std::vector<std::vector<glm::dvec3>> perSlice(std::size_t(g.dims.z));
  parallelFor(
      g.dims.z,
      [&](std::ptrdiff_t k) {
        for (int j = 0; j < g.dims.y; ++j) {
          const T* row = &volume.at(0, j, int(k));
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

SectorFrame frameOf(const Geometry& geometry, const Beam& beam) {
  SectorFrame frame;
  frame.axis = glm::transpose(geometry.direction) * beam.axis;
  const glm::dvec3 size = glm::abs(frame.axis);
  const int main = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  frame.across = {main == 0 ? 1 : 0, main == 2 ? 1 : 2};
  frame.extent = geometry.spacing * glm::dvec3(geometry.dims - 1);
  frame.voxel = geometry.minSpacing();
  return frame;
}

glm::dvec3 middleOf(const std::vector<glm::dvec3>& points) {
  glm::dvec3 low = points.front(), high = low;
  for (const glm::dvec3& p : points) low = glm::min(low, p), high = glm::max(high, p);
  return 0.5 * (low + high);
}

// The line in which two sides meet, as an axis with the outline of the scanned region around it.
struct SweptOutline {
  glm::dvec3 point{0}, direction{0};
  std::vector<HullEdge> edges;  // normals: along the axis, away from it
};

// The point of a row that is nearest to the axis: seen around it, a row's ends do not bound the row.
glm::dvec3 nearestToAxis(const glm::dvec3& first, const glm::dvec3& last, const SweptOutline& outline) {
  const glm::dvec3 row = last - first, across = row - glm::dot(row, outline.direction) * outline.direction;
  const double squared = glm::dot(across, across);
  if (squared <= 0) return first;
  return first + row * std::clamp(glm::dot(outline.point - first, across) / squared, 0.0, 1.0);
}

SweptOutline outlineAround(const HullFace& low, const HullFace& high, const glm::dvec3& middle,
                           const std::vector<glm::dvec3>& ends) {
  SweptOutline outline;
  outline.direction = glm::normalize(glm::cross(low.normal, high.normal));
  // n . p = -offset on both sides, and the point is beside the middle.
  const glm::dmat3 rows = glm::transpose(glm::dmat3(low.normal, high.normal, outline.direction));
  outline.point =
      glm::inverse(rows) * glm::dvec3(-low.offset, -high.offset, glm::dot(outline.direction, middle));
  const auto place = [&](const glm::dvec3& p) {
    const glm::dvec3 d = p - outline.point;
    const double along = glm::dot(d, outline.direction);
    return glm::dvec2(along, glm::length(d - along * outline.direction));
  };
  std::vector<glm::dvec2> places;
  places.reserve(ends.size() * 3 / 2);
  for (std::size_t e = 0; e + 1 < ends.size(); e += 2) {
    places.push_back(place(ends[e]));
    places.push_back(place(ends[e + 1]));
    places.push_back(place(nearestToAxis(ends[e], ends[e + 1], outline)));
  }
  outline.edges = convexOutline(std::move(places), kMerging);
  return outline;
}

// What an edge of the outline is in the plane of the axis and the middle.
HullFace faceInMiddle(const SweptOutline& outline, const HullEdge& edge, const glm::dvec3& middle) {
  const glm::dvec3 d = middle - outline.point;
  const glm::dvec3 away = glm::normalize(d - glm::dot(d, outline.direction) * outline.direction);
  HullFace face;
  face.normal = edge.normal.x * outline.direction + edge.normal.y * away;
  face.offset = edge.offset - glm::dot(face.normal, outline.point);
  face.area = edge.length;
  return face;
}

double depthBehind(const HullFace& face, const glm::dvec3& p) {
  return -glm::dot(face.normal, p) - face.offset;
}

// The outline's bounds that are no anatomy. Where they lie closer around the middle than the hull's flat sides
// do, the fan was swept, and they become its sides.
Sweep boundsOf(const SweptOutline& outline, const SectorFrame& frame, const glm::dvec3& middle,
               SectorSides& sides) {
  std::vector<HullFace> faces;
  for (const HullEdge& edge : outline.edges) faces.push_back(faceInMiddle(outline, edge, middle));
  const SectorSides swept = findSectorSides(faces, frame);
  Sweep sweep{glm::vec3(outline.point), glm::vec3(outline.direction), {}};
  for (std::size_t e = 0; e < faces.size(); ++e)
    if (!isAnatomy(faces[e], swept, frame))
      sweep.bounds.emplace_back(outline.edges[e].normal.x, outline.edges[e].normal.y,
                                outline.edges[e].offset);
  for (std::size_t s = 0; s < sides.size(); ++s)
    if (swept[s] && (!sides[s] || depthBehind(*swept[s], middle) < depthBehind(*sides[s], middle)))
      sides[s] = swept[s];
  return sweep;
}

FieldOfView boundsOfHull(const std::vector<glm::dvec3>& ends, const SectorFrame& frame) {
  FieldOfView view;
  const std::vector<HullFace> faces = convexHull(ends, kMerging);
  if (faces.empty()) return view;
  const glm::dvec3 middle = middleOf(ends);
  const SectorSides flat = findSectorSides(faces, frame);
  for (const HullFace& face : faces)
    (isAnatomy(face, flat, frame) ? view.front : view.sides)
        .emplace_back(glm::vec3(face.normal), float(face.offset));
  SectorSides sides = flat;
  for (std::size_t pair = 0; pair < 4; pair += 2)
    if (opensTowards(flat[pair], flat[pair + 1], frame.axis))
      view.sweeps.push_back(
          boundsOf(outlineAround(*flat[pair], *flat[pair + 1], middle, ends), frame, middle, sides));
  if (const auto origin = sectorOrigin(sides, frame, middle)) view.origin = glm::vec3(*origin);
  return view;
}

}  // namespace

float Sweep::depth(const glm::vec3& position) const {
  const glm::vec2 at = place(position);
  float least = 1e30f;
  for (const glm::vec3& b : bounds) least = std::min(least, -(b.x * at.x + b.y * at.y + b.z));
  return least;
}

float FieldOfView::depth(const glm::vec3& position) const {
  if (inside) return depthInMask(*inside, position);
  float least = depthBehind(sides, position);
  for (const Sweep& sweep : sweeps) least = std::min(least, sweep.depth(position));
  return least;
}

FieldOfView findFieldOfView(const Volume<float>& volume, const Beam& beam, const Progress& progress) {
  return boundsOfHull(rowEnds(volume, progress), frameOf(volume.geometry, beam));
}

FieldOfView findFieldOfView(const Scan& scan, const Beam& beam, const Progress& progress) {
  if (!scan.mask) return findFieldOfView(*scan.volume, beam, progress);
  const auto ends = rowEnds(*scan.mask, progress.part(0, 0.1));
  FieldOfView view;
  view.origin = boundsOfHull(ends, frameOf(scan.mask->geometry, beam)).origin;
  view.inside = std::make_shared<const Volume<std::uint8_t>>(maskDepth(*scan.mask, progress.part(0.1, 1)));
  return view;
}

Beam beamWithin(const FieldOfView& view, Beam beam, const Geometry& geometry, const ScanOptions& options) {
  if (options.beamOrigin == BeamOrigin::automatic && !beam.apex && view.origin)
    beam.apex = geometry.toWorld(glm::dvec3(*view.origin) / geometry.spacing);
  return beam;
}

}  // namespace sonoskin
