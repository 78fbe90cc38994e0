#include "core/mesh/vertex_rings.h"

namespace sonoskin {

VertexRings::VertexRings(const Mesh& mesh)
    : start_(mesh.positions.size() + 2, 0), ring_(6 * mesh.triangles.size()) {
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) start_[v + 2] += 2;
  for (std::size_t v = 2; v < start_.size(); ++v) start_[v] += start_[v - 1];
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& at = start_[t[i] + 1];
      ring_[at++] = t[(i + 1) % 3];
      ring_[at++] = t[(i + 2) % 3];
    }
  start_.pop_back();
}

}  // namespace sonoskin
