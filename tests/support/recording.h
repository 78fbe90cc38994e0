#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "core/phantom/phantom.h"

namespace sonoskin::test {

// writeRecording: an NRRD file of simulated scans of one head, each with its own speckle, as time steps .25 s apart.
inline void writeRecording(const std::filesystem::path& path, PhantomOptions phantom, int steps) {
  std::ofstream file(path, std::ios::binary);
  for (int step = 0; step < steps; ++step) {
    phantom.seed = step + 1;
    const Scan scan = makePhantomScan(phantom);
    const Geometry& g = scan.volume->geometry;
    const auto text = [](const glm::dvec3& v) { return fmt::format("({},{},{})", v.x, v.y, v.z); };
    if (step == 0)
      file << "NRRD0004\ntype: uint8\ndimension: 4\nencoding: raw\nspace: left-posterior-superior\n"
           << fmt::format("sizes: {} {} {} {}\nspace directions: {} {} {} none\nspace origin: {}\n", g.dims.x,
                          g.dims.y, g.dims.z, steps, text(g.direction[0] * g.spacing.x),
                          text(g.direction[1] * g.spacing.y), text(g.direction[2] * g.spacing.z),
                          text(g.origin))
           << "kinds: domain domain domain time\n\n";
    for (const float value : scan.volume->data) file.put(char(std::uint8_t(255 * value + 0.5f)));
  }
}

}  // namespace sonoskin::test
