#include "core/io/headers/nrrd_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/headers/axis_roles.h"
#include "core/io/headers/units.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
using Axis = NrrdAxis;
using Centre = NrrdAxis::Centre;

std::vector<double> numbersOf(const NrrdFields& nrrd, const char* field, std::size_t count,
                              const fs::path& path) {
  std::vector<double> numbers;
  for (const std::string_view word : words(nrrd[field])) {
    const auto number = lowerCase(word) == "nan" ? kNone : parseNumber<double>(word);
    require(number && !std::isinf(*number),
            "The spacing in {} is not known here; it must be positive, correct the header.", path.string());
    numbers.push_back(*number);
  }
  require(numbers.empty() || numbers.size() == count,
          "{} does not give one number per axis ({}); correct the header.", path.string(), field);
  numbers.resize(count, kNone);
  return numbers;
}

std::vector<std::string> textsOf(const NrrdFields& nrrd, const char* field, std::size_t count,
                                 const fs::path& path) {
  std::vector<std::string> texts = quotedWords(nrrd[field]);
  require(texts.empty() || texts.size() == count,
          "{} does not give one word per axis ({}); correct the header.", path.string(), field);
  texts.resize(count);
  return texts;
}

Centre centreOf(std::string_view word) {
  const std::string small = lowerCase(word);
  return small == "cell" ? Centre::cell : small == "node" ? Centre::node : Centre::unsaid;
}

}  // namespace

std::vector<NrrdAxis> nrrdAxes(const NrrdFields& nrrd, std::size_t count, const fs::path& path) {
  std::vector<Axis> axes(count);
  const char* centres = nrrd["centers"].empty() ? "centerings" : "centers";
  const auto spacings = numbersOf(nrrd, "spacings", count, path),
             least = numbersOf(nrrd, "axismins", count, path),
             most = numbersOf(nrrd, "axismaxs", count, path);
  const auto units = textsOf(nrrd, "units", count, path), kinds = textsOf(nrrd, "kinds", count, path),
             centred = textsOf(nrrd, centres, count, path);
  const auto directions = nrrdVectors(nrrd["spacedirections"], path);
  require(directions.empty() || directions.size() == count,
          "The directions of the axes in {} are not {} vectors; correct the header.", path.string(), count);
  for (std::size_t a = 0; a < count; ++a) {
    axes[a] = {spacings[a], least[a], most[a], centreOf(centred[a]), units[a], kinds[a], {}};
    if (!directions.empty()) axes[a].direction = directions[a];
  }
  return axes;
}

namespace {

// What an axis is whose kind the file does not tell.
void guessRoles(const std::vector<Axis>& axes, bool directed, std::vector<AxisRole>& roles,
                const fs::path& path) {
  for (std::size_t a = 0; a < axes.size(); ++a) {
    if (roles[a] != AxisRole::unsaid) continue;
    if (axes[a].direction && axes[a].direction->size() <= 3) roles[a] = AxisRole::space;
    if (secondsIn(axes[a].unit)) roles[a] = AxisRole::time;
  }
  const auto known = [&](AxisRole role) { return std::count(roles.begin(), roles.end(), role); };
  const auto open = known(AxisRole::unsaid), missing = 3 - known(AxisRole::space);
  if (open == 0) return;
  if (open == missing) {
    std::replace(roles.begin(), roles.end(), AxisRole::unsaid, AxisRole::space);
    return;
  }
  require(roles.size() == 3 || roles.size() == 4, "{} has {} dimensions; a volume has 3, or 4 with time.",
          path.string(), roles.size());
  // One more than space has: time, where it comes last and cannot be colour.
  require(open == missing + 1 && roles.back() == AxisRole::unsaid && roles.size() == 4 &&
              roles[0] != AxisRole::colour,
          "{} does not say which of its axes is time or colour; save it with \"kinds\".", path.string());
  roles.back() = AxisRole::time;
  std::replace(roles.begin(), roles.end(), AxisRole::unsaid, AxisRole::space);
  if (!directed)
    log(LogLevel::warning, "The file does not say what its fourth axis is; it is taken for time.");
}

}  // namespace

std::vector<AxisRole> nrrdRoles(const std::vector<NrrdAxis>& axes, const std::vector<std::int64_t>& sizes,
                                const fs::path& path) {
  std::vector<AxisRole> roles;
  for (const Axis& axis : axes) roles.push_back(axis.kind.empty() ? AxisRole::unsaid : roleOfKind(axis.kind));
  // Without directions nothing tells a short first axis of space from colour.
  const bool directed =
      std::any_of(axes.begin(), axes.end(), [](const Axis& a) { return a.direction.has_value(); });
  const bool mayBeColour =
      axes.size() == 4 && roles[0] == AxisRole::unsaid && !axes[0].direction && sizes[0] <= 4 && sizes[0] > 1;
  require(!mayBeColour, "{} does not say which of its four axes is time or colour; save it with \"kinds\".",
          path.string());
  guessRoles(axes, directed, roles, path);
  return roles;
}

}  // namespace sonoskin
