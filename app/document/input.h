#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/document/measures.h"
#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/pipeline/parameters.h"
#include "core/pipeline/recipe.h"
#include "core/volume/scan.h"

namespace sonoskin {

// kPhantomInput: stands for the simulated scan where a file name is expected.
inline constexpr const char* kPhantomInput = "phantom";

// InputFiles: what a scan is made from; empty names: none.
//   volume  "phantom", or a volume file
//   mask    a volume file that is not zero where something was scanned
//   erased  a volume file that is not zero where nothing counts, such as an arm
//   recipe  what a recipe says of the input
//   measures  that the session of the recipe holds
struct InputFiles {
  std::string volume, mask, erased;
  RecipeInput recipe{};
  std::vector<Measure> measures{};
};

// loadInput: the scan that the files name, with the spacing of scan.spacing where its file gives none. What the recipe erases
// is erased of its own scan alone, where no file says what is.
//   errors  Error: see readScan, fitIntoMemory, setMask, setErased and fromRunLengths; Cancelled
Scan loadInput(const InputFiles& files, const Parameters& parameters, const Progress& progress = {});

// erasedIn: what a recipe erases of a scan; nothing, and a warning, where it is of another one.
//   errors  Error: see fromRunLengths
std::optional<Volume<std::uint8_t>> erasedIn(const RecipeInput& recipe, const Scan& scan);

// measuresOf: the measures of the session, where it is of this scan; none, and a warning, where it is of another one.
std::vector<Measure> measuresOf(const InputFiles& files, const Scan& scan);

// fitIntoMemory: leaves of a scan what the options say.
//   errors  Error: see reduceScan; there is not enough memory to make a mesh of it
void fitIntoMemory(Scan& scan, const ScanOptions& options);

// warnOfSpacing: logs that a scan's spacing is not known, where it is not.
void warnOfSpacing(const Scan& scan);

// noteTimeSteps: logs that a scan is the first of several time steps, where only one is used and none was chosen.
void noteTimeSteps(const Scan& scan);

// withLandmarks: the parameters, with the phantom's own landmarks where it is the input and none are set.
Parameters withLandmarks(Parameters parameters, const std::string& input);

// inputName: the name of a file or folder without the folders that it lies in. For the person who gave it; what leaves the
// machine holds it only where that person asked for it.
std::string inputName(const std::string& input);

// isMeshFile: whether a file's ending is that of a mesh, or the file is one of VTK's with polygons.
bool isMeshFile(const std::string& file);

// boxAround: the box of a surface and a little more: what a ray-cast shows of the volume, so that the wall of the uterus
// between probe and face is not in the way.
Box boxAround(const Mesh& mesh);

// middleOf: the vertex in the middle of a surface: the one nearest to the median of all, axis by axis.
//   mesh  not empty
glm::dvec3 middleOf(const Mesh& mesh);

}  // namespace sonoskin
