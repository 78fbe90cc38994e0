#include "core/pipeline/result_bytes.h"

namespace sonoskin {

std::size_t bytesOf(const Volume<float>& volume) { return volume.data.size() * sizeof(float); }

std::size_t bytesOf(const Prepared& prepared) {
  return prepared.smoothed.lowPassed.data.size() * sizeof(float);
}

std::size_t bytesOf(const FoundPoints& found) {
  return found.thinned->data.size() + found.points->size() * 28;
}

std::size_t bytesOf(const ScanEvidence&) { return sizeof(ScanEvidence); }

std::size_t bytesOf(const FaceFit&) { return sizeof(FaceFit); }

std::size_t bytesOf(const FittedSurface& fit) { return fit.bytes; }

std::size_t bytesOf(const Mesh& mesh) {
  return mesh.positions.size() * 24 + mesh.triangles.size() * sizeof(Triangle);
}

std::size_t bytesOf(const std::vector<Mesh>& pieces) {
  std::size_t bytes = 0;
  for (const Mesh& m : pieces) bytes += bytesOf(m);
  return bytes;
}

std::size_t bytesOf(const PartedSurface& surface) {
  return bytesOf(surface.mesh) + 2 * surface.parts.ofTriangle.size() * sizeof(std::uint32_t) +
         surface.parts.graph.size() * 10 * sizeof(float);
}

std::size_t bytesOf(const KeptParts& kept) {
  return bytesOf(kept.mesh) + kept.verdicts.size() * sizeof(PartVerdict);
}

}  // namespace sonoskin
