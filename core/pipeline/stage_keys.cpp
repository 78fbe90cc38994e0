#include "core/pipeline/stage_keys.h"

#include "core/mesh/repair/clean.h"
#include "core/pipeline/kept_parts.h"
#include "core/pipeline/parameter_key.h"

// The number behind a stage's name is that of its code: a stage whose code changes its results gets another.
namespace sonoskin {
namespace {

template <class Options>
Key keyOf(const char* stage, const Key& input, const Options& options) {
  Hasher hasher(stage);
  hasher.add(input);
  addOptions(hasher, options);
  return hasher.key();
}

Key preparedKey(const Key& input, const Parameters& p) {
  Hasher hasher("prepare 3");
  hasher.add(input).add(p.classification.lowPass).add(p.classification.directionScale);
  addOptions(hasher, p.scan);
  return hasher.key();
}

Key faceKey(const Key& points, const FaceOptions& options) {
  if (!options.find) return {};
  return Hasher("face 1").add(points).add(options.headHeight).key();
}

Key fitKey(const Key& points, const Parameters& p) {
  if (p.reconstruction.method == ReconstructionMethod::global) return keyOf("fit global 1", points, p.global);
  return keyOf("fit 2", points, p.reconstruction);
}

Key piecesKey(const Key& fit, const MeshOptions& mesh) {
  Hasher hasher("surface 3");
  hasher.add(fit).add(mesh.resolution).add(mesh.cell).add(mesh.support).add(mesh.maxGap);
  return hasher.add(mesh.density).add(mesh.narrowest).add(mesh.fillHoles).key();
}

Key partsKey(const Key& pieces, const MeshOptions& mesh) {
  Hasher hasher("parts 1");
  hasher.add(pieces);
  addPlaces(hasher, mesh.partsCut);
  return hasher.key();
}

// Whole pieces do not depend on the face.
Key keptKey(const StageKeys& keys, const Parameters& p, const Precision& precision) {
  const MeshOptions& mesh = p.mesh;
  Hasher hasher("piece 4");
  hasher.add(mesh.piece).add(mesh.companions).add(mesh.pieceIndex);
  hasher.add(std::span<const double>(mesh.piecePoint)).add(mesh.parts);
  addPlaces(hasher, mesh.partsAdd);
  addPlaces(hasher, mesh.partsDrop);
  if (!cutsParts(mesh)) return hasher.add(keys.pieces).key();
  hasher.add(keys.parts).add(keys.face).add(precision.face);
  addOptions(hasher, p.face);
  return hasher.key();
}

Key cleanKey(const Key& kept, const MeshOptions& mesh) {
  if (!needsCleaning(mesh)) return kept;
  Hasher hasher("clean 2");
  hasher.add(kept).add(mesh.minArea).add(mesh.fillHoles).add(mesh.smoothing).add(mesh.triangles);
  return hasher.key();
}

}  // namespace

StageKeys stageKeys(const Key& scan, const Key& erased, const Parameters& p, const Precision& precision) {
  StageKeys keys;
  const bool enhances = p.enhancement.method != EnhancementMethod::none;
  keys.enhanced = enhances ? keyOf("enhance 1", scan, p.enhancement) : scan;
  keys.prepared = preparedKey(keys.enhanced, p);
  const char* classification = precision.solved ? "classify 2" : "classify live 1";
  keys.classified = keyOf(classification, keys.prepared, p.classification);
  const Key region = keyOf("region", erased, p.region);
  keys.points = keyOf("points 3", Hasher("in").add(keys.classified).add(region).key(), p.surface);
  keys.face = faceKey(keys.points, p.face);
  keys.fit = fitKey(keys.points, p);
  keys.pieces = piecesKey(keys.fit, p.mesh);
  keys.parts = partsKey(keys.pieces, p.mesh);
  keys.kept = keptKey(keys, p, precision);
  keys.mesh = cleanKey(keys.kept, p.mesh);
  keys.print = keyOf("print 1", keys.mesh, p.print);
  return keys;
}

Key parametersKey(const Parameters& parameters) {
  Hasher hasher("parameters");
  groups([&](const Group&, const auto& options) { addOptions(hasher, options); }, parameters);
  return hasher.key();
}

}  // namespace sonoskin
