#include "app/document/input.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/base/available_memory.h"
#include "core/base/log.h"
#include "core/io/file_formats.h"
#include "core/io/meshes/vtk_surface_reader.h"
#include "core/io/volume_reader.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/phantom_landmarks.h"
#include "core/volume/mirror_scan.h"
#include "core/volume/scan_size.h"

namespace sonoskin {

Scan loadInput(const InputFiles& files, const Parameters& parameters, const Progress& progress) {
  const Progress volume = files.mask.empty() && files.erased.empty() ? progress : progress.part(0, 0.8);
  Scan scan = files.volume == kPhantomInput
                  ? makePhantomScan(parameters.phantom, volume)
                  : readScan(files.volume, readOptions(parameters.scan, parameters.raw), volume);
  if (!scan.spacingKnown) setSpacing(scan, parameters.scan.spacing);
  warnOfSpacing(scan);
  fitIntoMemory(scan, parameters.scan);
  if (!files.mask.empty()) setMask(scan, readMarks(files.mask, parameters.raw, progress.part(0.8, 0.9)));
  if (!files.erased.empty()) setErased(scan, readMarks(files.erased, parameters.raw, progress.part(0.9, 1)));
  mirrorScan(scan, parameters.scan.mirror);  // with the masks, which lie where the file has its voxels
  if (!files.erased.empty()) return scan;
  if (auto erased = erasedIn(files.recipe, scan)) setErased(scan, std::move(*erased));
  return scan;
}

std::optional<Volume<std::uint8_t>> erasedIn(const RecipeInput& recipe, const Scan& scan) {
  if (recipe.erased.counts.empty()) return {};
  if (scan.volume && recipe.key == scan.key.hex())
    return fromRunLengths(recipe.erased, scan.volume->geometry);
  log(LogLevel::warning, "What the recipe erases is of another volume; nothing is erased of this one.");
  return {};
}

std::vector<Measure> measuresOf(const InputFiles& files, const Scan& scan) {
  if (files.measures.empty() || files.recipe.key == scan.key.hex()) return files.measures;
  log(LogLevel::warning, "The measures of the session are of another volume; the report has none of them.");
  return {};
}

void fitIntoMemory(Scan& scan, const ScanOptions& options) {
  reduceScan(scan, options);
  requireMemory(scan.volume->geometry, kBytesPerVoxel - kBytesToRead, availableMemory());
}

void warnOfSpacing(const Scan& scan) {
  if (!scan.spacingKnown)
    log(LogLevel::warning,
        "The file gives no spacing and 1 mm is assumed, so that lengths and areas mean nothing; give it as "
        "scan.spacing.");
}

void noteTimeSteps(const Scan& scan) {
  if (scan.timeSteps > 1 && scan.time == 1)
    log(LogLevel::info, fmt::format("The scan has {} time steps; the first is used.", scan.timeSteps));
}

Parameters withLandmarks(Parameters parameters, const std::string& input) {
  if (input == kPhantomInput && !hasLandmarks(parameters.landmarks))
    parameters.landmarks = phantomLandmarks(parameters.phantom);
  return parameters;
}

std::string inputName(const std::string& input) {
  const std::filesystem::path path = std::filesystem::path(input).lexically_normal();
  // A folder of a DICOM series may end in a slash; its name is the part before.
  return path.has_filename() ? path.filename().string() : path.parent_path().filename().string();
}

bool isMeshFile(const std::string& file) {
  return formatNamed(FileKind::readMesh, file).has_value() || isVtkSurface(file);
}

Box boxAround(const Mesh& mesh) {
  constexpr float kMargin = 1.5f;  // mm; the grey of an echo begins a little above the surface found in it
  const Box box = boundingBox(mesh.positions);
  return {box.min - kMargin, box.max + kMargin};
}

glm::dvec3 middleOf(const Mesh& mesh) {
  glm::vec3 median(0);
  std::vector<float> along(mesh.positions.size());
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t v = 0; v < along.size(); ++v) along[v] = mesh.positions[v][axis];
    const auto middle = along.begin() + std::ptrdiff_t(along.size() / 2);
    std::nth_element(along.begin(), middle, along.end());
    median[axis] = *middle;
  }
  const auto nearer = [&](const glm::vec3& a, const glm::vec3& b) {
    return glm::distance(a, median) < glm::distance(b, median);
  };
  return glm::dvec3(*std::min_element(mesh.positions.begin(), mesh.positions.end(), nearer));
}

}  // namespace sonoskin
