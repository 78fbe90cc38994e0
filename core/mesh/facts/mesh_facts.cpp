#include "core/mesh/facts/mesh_facts.h"

#include "core/mesh/components.h"
#include "core/mesh/search/self_intersections.h"

namespace sonoskin {

MeshFacts measureMesh(const Mesh& mesh, const Progress& progress) {
  MeshFacts facts;
  facts.check = checkMesh(mesh, progress.part(0, 0.3));
  progress.update(0.3);
  facts.triangles = mesh.triangles.size();
  facts.pieces = splitPieces(mesh, progress.part(0.3, 0.4)).size();
  facts.area = surfaceArea(mesh);
  if (facts.check.closed()) facts.volume = enclosedVolume(mesh);
  const Box box = boundingBox(mesh.positions);
  facts.size = box.max - box.min;
  facts.selfIntersections = countSelfIntersections(mesh, progress.part(0.4, 1));
  progress.update(1);
  return facts;
}

}  // namespace sonoskin
