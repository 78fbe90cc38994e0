#include "core/pipeline/stage_keys.h"

#include "core/mesh/repair/clean.h"
#include "core/pipeline/parameter_key.h"

namespace sonoskin {
namespace {

template <class Options>
Key keyOf(const char* stage, const Key& input, const Options& options) {
  Hasher hasher(stage);
  hasher.add(input);
  addOptions(hasher, options);
  return hasher.key();
}

}  // namespace

Key enhancedKey(const Key& scan, const EnhancementOptions& options) {
  return options.method == EnhancementMethod::none ? scan : keyOf("enhanced", scan, options);
}

Key coarserKey(const Key& volume) { return Hasher("coarser").add(volume).key(); }

Key preparedKey(const Key& volume, const Parameters& p) {
  Hasher hasher("prepared");
  hasher.add(volume).add(p.classification.lowPass).add(p.classification.directionScale);
  ScanOptions scan = p.scan;  // what is left out of the volume its own key tells
  scan.volume = 0, scan.time = 1;
  scan.half = scan.regionOnly = false;
  scan.voxel = 0;
  scan.mirror = MirroredAxis::none;
  scan.cutLow = scan.cutHigh = {};
  addOptions(hasher, scan);
  return hasher.key();
}

Key classifiedKey(const Key& prepared, const ClassificationOptions& options, bool live) {
  return keyOf(live ? "classified live" : "classified", prepared, options);
}

Key pointsKey(const Key& classified, const Key& erased, const Parameters& p) {
  const Key region = keyOf("region", erased, p.region);
  return keyOf("points", Hasher("in").add(classified).add(region).key(), p.surface);
}

Key evidenceKey(const Key& points) { return Hasher("evidence").add(points).key(); }

Key faceKey(const Key& points, const FaceOptions& options) {
  if (!options.find) return {};
  return Hasher("face").add(points).add(options.headHeight).key();
}

Key fitKey(const Key& points, const Parameters& p) {
  if (p.reconstruction.method == ReconstructionMethod::global) return keyOf("global fit", points, p.global);
  return keyOf("fit", points, p.reconstruction);
}

Key piecesKey(const Key& fit, const MeshOptions& mesh) {
  Hasher hasher("pieces");
  hasher.add(fit).add(mesh.resolution).add(mesh.cell).add(mesh.support).add(mesh.maxGap);
  return hasher.add(mesh.density).add(mesh.narrowest).add(mesh.fillHoles).key();
}

Key partsKey(const Key& pieces, const MeshOptions& mesh) {
  Hasher hasher("parts");
  hasher.add(pieces);
  addPlaces(hasher, mesh.partsCut);
  return hasher.key();
}

Key keptKey(const Key& surface, const Key& face, const Parameters& p) {
  const MeshOptions& mesh = p.mesh;
  Hasher hasher("kept");
  hasher.add(mesh.piece).add(mesh.companions).add(mesh.pieceIndex);
  hasher.add(std::span<const double>(mesh.piecePoint)).add(mesh.parts);
  addPlaces(hasher, mesh.partsAdd);
  addPlaces(hasher, mesh.partsDrop);
  hasher.add(surface);
  if (!cutsParts(mesh)) return hasher.key();
  hasher.add(face);
  addOptions(hasher, p.face);
  return hasher.key();
}

Key cleanKey(const Key& kept, const MeshOptions& mesh) {
  if (!needsCleaning(mesh)) return kept;
  Hasher hasher("clean");
  hasher.add(kept).add(mesh.minArea).add(mesh.fillHoles).add(mesh.smoothing).add(mesh.triangles);
  return hasher.key();
}

Key printKey(const Key& mesh, const PrintOptions& options) { return keyOf("print", mesh, options); }

StageKeys stageKeys(const Key& scan, const Key& erased, const Parameters& p) {
  StageKeys keys;
  keys.enhanced = enhancedKey(scan, p.enhancement);
  keys.prepared = preparedKey(keys.enhanced, p);
  keys.classified = classifiedKey(keys.prepared, p.classification);
  keys.points = pointsKey(keys.classified, erased, p);
  keys.evidence = evidenceKey(keys.points);
  keys.face = faceKey(keys.points, p.face);
  keys.fit = fitKey(keys.points, p);
  keys.pieces = piecesKey(keys.fit, p.mesh);
  keys.parts = partsKey(keys.pieces, p.mesh);
  keys.kept = keptKey(cutsParts(p.mesh) ? keys.parts : keys.pieces, keys.face, p);
  keys.mesh = cleanKey(keys.kept, p.mesh);
  keys.print = printKey(keys.mesh, p.print);
  return keys;
}

Key parametersKey(const Parameters& parameters) {
  Hasher hasher("parameters");
  groups([&](const Group&, const auto& options) { addOptions(hasher, options); }, parameters);
  return hasher.key();
}

}  // namespace sonoskin
