#include "core/mesh/repair/clean.h"

#include "core/mesh/components.h"
#include "core/mesh/half_edges.h"
#include "core/mesh/repair/decimate.h"
#include "core/mesh/repair/fill_holes.h"
#include "core/mesh/repair/smooth.h"

namespace sonoskin {
namespace {

Mesh withoutSmallPieces(const Mesh& mesh, double minArea, const Progress& progress) {
  std::vector<Mesh> pieces = splitPieces(mesh, progress);  // largest first
  std::size_t kept = pieces.empty() ? 0 : 1;
  while (kept < pieces.size() && surfaceArea(pieces[kept]) >= minArea) ++kept;
  pieces.resize(kept);
  return joinPieces(pieces);
}

}  // namespace

bool needsCleaning(const MeshOptions& o) {
  return o.minArea > 0 || o.fillHoles > 0 || o.smoothing > 0 || o.triangles > 0;
}

Mesh cleanMesh(const Mesh& mesh, const MeshOptions& options, const Progress& progress) {
  Mesh clean = mesh;
  if (options.minArea > 0) clean = withoutSmallPieces(clean, options.minArea, progress.part(0, 0.1));
  if (options.fillHoles > 0)
    clean = fillHoles(clean, {options.fillHoles, Outline::keepUnlessSmall, false}, progress.part(0.1, 0.3));
  else
    splitFans(clean);
  smoothMesh(clean, options.smoothing, progress.part(0.3, 0.7));
  if (options.triangles > 0)
    clean = decimateMesh(clean, std::size_t(options.triangles), progress.part(0.7, 1));
  progress.update(1);
  return clean;
}

}  // namespace sonoskin
