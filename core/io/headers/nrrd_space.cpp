#include "core/io/headers/nrrd_space.h"

#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/headers/units.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

struct Named {
  int dimension;
  glm::dvec3 toLps;
};

// As the format's page lists them, in small letters without what stands between the words.
const std::map<std::string, Named, std::less<>>& namedSpaces() {
  static const std::map<std::string, Named, std::less<>> spaces{
      {"rightanteriorsuperior", {3, {-1, -1, 1}}},
      {"ras", {3, {-1, -1, 1}}},
      {"leftanteriorsuperior", {3, {1, -1, 1}}},
      {"las", {3, {1, -1, 1}}},
      {"leftposteriorsuperior", {3, {1, 1, 1}}},
      {"lps", {3, {1, 1, 1}}},
      {"rightanteriorsuperiortime", {4, {-1, -1, 1}}},
      {"rast", {4, {-1, -1, 1}}},
      {"leftanteriorsuperiortime", {4, {1, -1, 1}}},
      {"last", {4, {1, -1, 1}}},
      {"leftposteriorsuperiortime", {4, {1, 1, 1}}},
      {"lpst", {4, {1, 1, 1}}},
      {"scannerxyz", {3, {1, 1, 1}}},
      {"scannerxyztime", {4, {1, 1, 1}}},
      {"3drighthanded", {3, {1, 1, 1}}},
      {"3drighthandedtime", {4, {1, 1, 1}}},
      {"3dlefthanded", {3, {1, -1, 1}}},
      {"3dlefthandedtime", {4, {1, -1, 1}}}};
  return spaces;
}

std::string plainName(std::string_view text) {
  std::string name = lowerCase(text);
  std::erase_if(name, [](char c) { return c == '-' || c == ' ' || c == '_'; });
  return name;
}

void applyName(const NrrdFields& nrrd, NrrdSpace& space, const fs::path& path) {
  const std::string name = plainName(nrrd["space"]);
  const auto found = namedSpaces().find(name);
  require(found != namedSpaces().end(), "{} names a space which NRRD does not have; correct the header.",
          path.string());
  require(space.dimension == 0 || space.dimension == found->second.dimension,
          "{} has a space and a space dimension that contradict each other; correct the header.",
          path.string());
  space.dimension = found->second.dimension;
  space.toLps = found->second.toLps;
  space.hasTime = space.dimension == 4;
  // Numbers of a left-handed frame, taken as they are, would be the mirror image of what was recorded.
  if (name.starts_with("3dlefthanded"))
    log(LogLevel::warning,
        "The file lies in a left-handed frame without anatomy; its second axis is turned over, which keeps "
        "left "
        "and right of what was recorded.");
}

void applyUnits(const NrrdFields& nrrd, NrrdSpace& space, const fs::path& path) {
  const std::vector<std::string> units = quotedWords(nrrd["spaceunits"]);
  if (units.empty()) return;
  require(units.size() == std::size_t(space.dimension),
          "The space units in {} are not {} words; correct the header.", path.string(), space.dimension);
  for (int a = 0; a < std::min(3, space.dimension); ++a)
    space.toLps[a] *= millimetresOrWarn(units[std::size_t(a)]);
  if (space.hasTime) space.timeUnit = secondsIn(units[3]).value_or(0);
}

}  // namespace

glm::dvec3 NrrdSpace::world(const std::vector<double>& vector) const {
  glm::dvec3 at(0);
  for (std::size_t a = 0; a < std::min<std::size_t>(vector.size(), 3); ++a)
    at[int(a)] = toLps[int(a)] * vector[a];
  return at;
}

NrrdSpace nrrdSpace(const NrrdFields& nrrd, const fs::path& path) {
  NrrdSpace space;
  if (nrrd.fields.contains("spacedimension")) {
    const auto dimension = parseNumber<int>(nrrd["spacedimension"]);
    require(dimension && (*dimension == 2 || *dimension == 3),
            "The space of {} does not have three dimensions; save it with time as an axis of its own.",
            path.string());
    space.dimension = *dimension;
  }
  if (!nrrd["space"].empty()) {
    applyName(nrrd, space, path);
  } else if (space.dimension == 0 && !nrrd["spacedirections"].empty()) {
    const auto vectors = nrrdVectors(nrrd["spacedirections"], path);
    const auto given =
        std::find_if(vectors.begin(), vectors.end(), [](const auto& v) { return v.has_value(); });
    space.dimension = given == vectors.end() ? 3 : int((*given)->size());
    require(space.dimension == 2 || space.dimension == 3,
            "The space of {} does not have three dimensions; correct the header.", path.string());
  }
  if (nrrd["space"].empty() && space.dimension > 0)
    log(LogLevel::warning,
        "The file does not name its space; it is taken for a right-handed one, left and right may be wrong.");
  applyUnits(nrrd, space, path);
  return space;
}

}  // namespace sonoskin
