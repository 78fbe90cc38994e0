#include "core/pipeline/stage_keys.h"

namespace sonoskin {

Key preparedKey(const Key& input, const Parameters& p) {
  Hasher hasher("prepare 3");
  hasher.add(input).add(p.classification.lowPass).add(p.classification.directionScale);
  addOptions(hasher, p.scan);
  return hasher.key();
}

Key partsKeyOf(const Key& surface, const MeshOptions& mesh) {
  Hasher hasher("parts 1");
  hasher.add(surface);
  addPlaces(hasher, mesh.partsCut);
  return hasher.key();
}

Key pieceKeyOf(const Key& surface, const MeshOptions& mesh) {
  Hasher hasher("piece 3");
  hasher.add(surface).add(mesh.piece).add(mesh.companions).add(mesh.pieceIndex);
  hasher.add(std::span<const double>(mesh.piecePoint)).add(mesh.parts);
  addPlaces(hasher, mesh.partsAdd);
  addPlaces(hasher, mesh.partsDrop);
  return hasher.key();
}

Key cleanKeyOf(const Key& piece, const MeshOptions& mesh) {
  Hasher hasher("clean 2");
  return hasher.add(piece)
      .add(mesh.minArea)
      .add(mesh.fillHoles)
      .add(mesh.smoothing)
      .add(mesh.triangles)
      .key();
}

Key surfaceKeyOf(const Key& fit, const MeshOptions& mesh) {
  Hasher hasher("surface 3");
  hasher.add(fit).add(mesh.resolution).add(mesh.cell).add(mesh.support).add(mesh.maxGap);
  return hasher.add(mesh.density).add(mesh.narrowest).add(mesh.fillHoles).key();
}

Key fitKeyOf(const Key& points, const Parameters& p) {
  if (p.reconstruction.method == ReconstructionMethod::global) return keyOf("fit global 1", points, p.global);
  return keyOf("fit 2", points, p.reconstruction);
}

}  // namespace sonoskin
