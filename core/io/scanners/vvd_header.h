#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace sonoskin {

// VvdVolume: what a .vvd says of one volume. Nothing else of it is kept: its metadata may be a patient's.
struct VvdVolume {
  std::string file, format;  // beside the .vvd; "uint8", "Vector3(uint8)", ...
  glm::dvec3 dims{0};
  std::optional<glm::dvec3> offset, spacing;
  std::optional<glm::dmat4> transformation;
};

// readVvdHeader: all volumes that a .vvd names.
//   errors  Error: no XML of Voreen, no volume in it, more than 4096, numbers that are none
std::vector<VvdVolume> readVvdHeader(const std::filesystem::path& path);

}  // namespace sonoskin
