#include "app/document/frame.h"

#include <utility>

#include "core/pipeline/scan_doubts.h"

namespace sonoskin {

void takeIn(Frame& frame, Results fresh, const MeshOrigin& origin, const FaceOptions& face) {
  const Results& before = frame.results;
  for (const StageReport& stage : fresh.stages)
    if (stage.seconds > 0) frame.seconds[stage.name] = stage.seconds;
  if (fresh.mesh) {
    frame.made = origin;
    frame.made.isFinal = fresh.isFinal;
    frame.meshArea = surfaceArea(*fresh.mesh);
  } else {
    fresh.mesh = before.mesh;
    fresh.pieces = before.pieces;
    fresh.parts = before.parts;
    fresh.verdicts = before.verdicts;
    fresh.centres = before.centres;
  }
  if (!fresh.classified) {  // slices alone
    fresh.classified = before.classified;
    fresh.keys = before.keys;
    fresh.stages = before.stages;
  }
  if (!fresh.thinned) fresh.thinned = before.thinned;
  if (!fresh.points) {
    fresh.points = before.points;
    fresh.edge = before.edge;
  }
  if (!fresh.face) fresh.face = before.face;  // sliders do not move it
  if (!fresh.evidence) fresh.evidence = before.evidence;
  if (fresh.evidence) fresh.warnings = doubtsOf(frame.scan, *fresh.evidence, fresh.face.get(), face);
  frame.results = std::move(fresh);
}

Results withSurfaceOf(Results results, const Results& others) {
  results.mesh = others.mesh;
  results.pieces = others.pieces;
  results.parts = others.parts;
  results.verdicts = others.verdicts;
  results.centres = others.centres;
  results.isFinal = others.isFinal;
  if (others.face) results.face = others.face;
  return results;
}

StageKeys keysOf(const Document& document, const Frame& frame) {
  return stageKeys(frame.scan.key, document.erased.key(), document.parameters);
}

bool meshIsCurrent(const Document& document, const Frame& frame) {
  return frame.results.mesh && frame.made.mesh == keysOf(document, frame).mesh;
}

}  // namespace sonoskin
