#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/pipeline/parameters.h"
#include "render/skin/light_rig.h"

namespace sonoskin::accuracy {

// SkinHead: a surface on which light is spread.
//   mesh   empty pointer: its file is not on this machine
//   home   how a viewer sees it first
struct SkinHead {
  std::string name;
  std::shared_ptr<const Mesh> mesh;
  HomeFrame home;
};

// skinHeads: the reconstruction of the simulated scan, a modelled baby at two sizes and a scanned adult.
std::vector<SkinHead> skinHeads(const Parameters& parameters);

}  // namespace sonoskin::accuracy
