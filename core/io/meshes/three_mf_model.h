#pragma once

#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/mesh.h"

// One model part of a 3MF file as it stands there.  [3MF Core Specification 1.3; Production Extension 1.1]
namespace sonoskin {

// ThreeMfUse: an object that is put somewhere, by a component of another object or to be built. `part` is the model part
// that has it; empty: the same one. `place` takes its points to where it is put.
struct ThreeMfUse {
  std::string part, object;
  glm::dmat4 place{1};
};

// ThreeMfObject: a mesh, or other objects, in the model's unit. isBuilt: no support for the printer, and nothing "other".
struct ThreeMfObject {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<ThreeMfUse> components;
  bool isBuilt = true;
};

struct ThreeMfModel {
  double millimetres = 1;  // of its unit
  std::map<std::string, ThreeMfObject, std::less<>> objects;
  std::vector<ThreeMfUse> items;
};

// parseThreeMf: of the XML of a model part.
//   errors  Error: no model, a unit or a required extension that is not known here, numbers that are none
ThreeMfModel parseThreeMf(std::string_view xml, const std::filesystem::path& path);

}  // namespace sonoskin
