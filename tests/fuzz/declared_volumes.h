#pragma once

#include <cmath>

#include "core/base/log.h"
#include "core/io/headers/declared_volume.h"
#include "tests/fuzz/fuzz_input.h"

namespace sonoskin::fuzz {

// readAndClaim: reads a volume; where it is accepted its geometry is finite, positive and orthonormal, and all numbers are there.
inline void readAndClaim(FileFormat format, const std::filesystem::path& path) {
  static const bool silent = (setLogListener([](LogLevel, const std::string&) {}), true);
  claim(silent, "warnings have a listener");
  const LoadedVolume volume = readDeclared(format, path, 1);
  const Geometry& g = volume.stored.geometry;
  claim(g.spacing.x > 0 && g.spacing.y > 0 && g.spacing.z > 0, "spacings are positive");
  for (int a = 0; a < 3; ++a) {
    claim(std::isfinite(g.spacing[a]) && std::isfinite(g.origin[a]), "places are finite");
    for (int b = 0; b < 3; ++b)
      claim(std::abs(glm::dot(g.direction[a], g.direction[b]) - (a == b)) < 1e-9, "axes are orthonormal");
  }
  claim(std::isfinite(volume.stored.stepSeconds) && volume.stored.stepSeconds >= 0, "steps take a time");
  claim(volume.numbers.size() ==
            g.voxels() * std::size_t(volume.stored.components) * numberTypeBytes(volume.stored.type),
        "all numbers are there");
}

}  // namespace sonoskin::fuzz
