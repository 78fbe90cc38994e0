#include "app/input.h"

#include <filesystem>

#include "core/io/volume_reader.h"
#include "core/phantom/phantom.h"

namespace sonoskin {

Scan loadInput(const std::string& input, const Parameters& parameters, const Progress& progress) {
  return input == kPhantomInput ? makePhantomScan(parameters.phantom, progress) : readScan(input, progress);
}

std::string inputName(const std::string& input) {
  const std::filesystem::path path = std::filesystem::path(input).lexically_normal();
  // A folder of a DICOM series may end in a slash; its name is the part before.
  return path.has_filename() ? path.filename().string() : path.parent_path().filename().string();
}

Box boxAround(const Mesh& mesh) {
  constexpr float kMargin = 1.5f;  // mm; the grey of an echo begins a little above the surface found in it
  const Box box = boundingBox(mesh.positions);
  return {box.min - kMargin, box.max + kMargin};
}

}  // namespace sonoskin
