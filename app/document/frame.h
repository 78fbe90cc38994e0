#pragma once

#include <map>
#include <memory>
#include <string>

#include "app/document/document.h"
#include "core/pipeline/results.h"
#include "core/volume/scan.h"

namespace sonoskin {

// MeshOrigin: what a surface was made from: all that its recipe needs.
struct MeshOrigin {
  Parameters parameters;
  std::shared_ptr<const Volume<std::uint8_t>> erased;
  Key mesh;
  bool isFinal = false;
  Key key() const { return Hasher("origin").add(mesh).add(isFinal).key(); }
};

// Frame: what belongs to one moment of a document: a scan and what was made of it. Members of the results stay until
// something newer replaces them: a mesh may be older than the document's parameters.
struct Frame {
  Scan scan;
  Results results;
  MeshOrigin made;      // of results.mesh
  double meshArea = 0;  // mm²
  std::map<std::string, double>
      seconds{};  // that the stages took, by their names, each when it was last made
};

// takeIn: newer results of the frame; what a coarse result, or a slider's answer, lacks stays as it was.
//   origin  what a mesh among them was made from
//   face    by which the warnings are judged
void takeIn(Frame& frame, Results fresh, const MeshOrigin& origin, const FaceOptions& face);

// withSurfaceOf: results, with the surface of others.
Results withSurfaceOf(Results results, const Results& others);

// keysOf: of all that the document leads to in this frame.
StageKeys keysOf(const Document& document, const Frame& frame);

// meshIsCurrent: whether the mesh is the one that the document leads to, short cuts aside.
bool meshIsCurrent(const Document& document, const Frame& frame);

}  // namespace sonoskin
