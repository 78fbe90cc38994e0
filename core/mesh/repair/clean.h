#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_options.h"

namespace sonoskin {

// cleanMesh: what `options` ask for, in this order: small pieces dropped (minArea; the largest stays), holes filled
// (fillHoles), smoothed (smoothing), reduced (triangles).
//   output   manifold: surfaces that touched in a point come apart
//   errors   Cancelled
Mesh cleanMesh(const Mesh& mesh, const MeshOptions& options, const Progress& progress = {});

// needsCleaning: whether the options ask for anything.
bool needsCleaning(const MeshOptions& options);

}  // namespace sonoskin
