#include "core/io/headers/axis_roles.h"

#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/header_text.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

std::vector<int> axesWith(const std::vector<AxisRole>& roles, std::initializer_list<AxisRole> wanted) {
  std::vector<int> axes;
  for (std::size_t a = 0; a < roles.size(); ++a)
    if (std::find(wanted.begin(), wanted.end(), roles[a]) != wanted.end()) axes.push_back(int(a));
  return axes;
}

// Of one sample, whatever it is called, unless it is one of the axes of space.
void dropSingles(std::vector<AxisRole>& roles, const DeclaredData& data) {
  for (std::size_t a = 0; a < roles.size(); ++a)
    if (data.sizes[a] == 1 && roles[a] != AxisRole::space) roles[a] = AxisRole::one;
}

void setComponents(const std::vector<AxisRole>& roles, DeclaredData& data, const fs::path& path) {
  require(axesWith(roles, {AxisRole::otherColour}).empty(),
          "{} has colours that are not red, green and blue; save it in grey.", path.string());
  const std::vector<int> axes = axesWith(roles, {AxisRole::colour, AxisRole::vector});
  if (axes.empty()) return;
  require(data.stored.components == 1,
          "{} has colours both as numbers of a voxel and along an axis; save it with one of them.",
          path.string());
  const std::int64_t size = data.sizes[std::size_t(axes[0])];
  const bool colour = roles[std::size_t(axes[0])] == AxisRole::colour;
  const bool likeColour = data.type == NumberType::uint8 && (size == 3 || size == 4);
  require(axes.size() == 1 && (colour || likeColour),
          "{} has {} numbers per voxel that are neither grey nor colour; save one of them.", path.string(),
          size);
  if (!colour)
    log(LogLevel::warning,
        "The file calls three or four bytes of a voxel a vector; they are taken for colour.");
  data.componentAxis = axes[0];
  data.stored.components = int(std::clamp<std::int64_t>(size, 1, 65535));
}

// A row of flat pictures: two axes of space, or three of which one has a single sample, and a list of many.
bool isRowOfPictures(const std::vector<int>& space, const std::vector<int>& rows, const DeclaredData& data) {
  if (rows.size() != 1) return false;
  if (space.size() == 2) return true;
  return space.size() == 3 && std::count_if(space.begin(), space.end(),
                                            [&](int a) { return data.sizes[std::size_t(a)] == 1; }) == 1;
}

void setDims(DeclaredData& data) {
  for (int a = 0; a < 3; ++a)
    data.stored.geometry.dims[a] = int(std::clamp<std::int64_t>(
        data.sizes[std::size_t(data.spaceAxes[std::size_t(a)])], -(1 << 20), 1 << 20));
}

}  // namespace

AxisRole roleOfKind(std::string_view kind) {
  static const std::map<std::string, AxisRole, std::less<>> roles{{"domain", AxisRole::space},
                                                                  {"space", AxisRole::space},
                                                                  {"time", AxisRole::time},
                                                                  {"list", AxisRole::list},
                                                                  {"3-color", AxisRole::colour},
                                                                  {"rgb-color", AxisRole::colour},
                                                                  {"rgbcolor", AxisRole::colour},
                                                                  {"4-color", AxisRole::colour},
                                                                  {"rgba-color", AxisRole::colour},
                                                                  {"rgbacolor", AxisRole::colour},
                                                                  {"3color", AxisRole::colour},
                                                                  {"4color", AxisRole::colour},
                                                                  {"hsv-color", AxisRole::otherColour},
                                                                  {"hsvcolor", AxisRole::otherColour},
                                                                  {"xyz-color", AxisRole::otherColour},
                                                                  {"xyzcolor", AxisRole::otherColour},
                                                                  {"none", AxisRole::unsaid},
                                                                  {"?", AxisRole::unsaid},
                                                                  {"??", AxisRole::unsaid},
                                                                  {"???", AxisRole::unsaid}};
  const auto found = roles.find(lowerCase(kind));
  return found == roles.end() ? AxisRole::vector : found->second;
}

void assignAxes(std::vector<AxisRole> roles, DeclaredData& data, const fs::path& path, bool tracked) {
  const bool asStack = axesWith(roles, {AxisRole::space}).size() == 3 &&
                       axesWith(roles, {AxisRole::time, AxisRole::list}).empty();
  if (tracked && asStack) roles[std::size_t(axesWith(roles, {AxisRole::space}).back())] = AxisRole::list;
  dropSingles(roles, data);
  std::vector<int> space = axesWith(roles, {AxisRole::space});
  const std::vector<int> rows = axesWith(roles, {AxisRole::time, AxisRole::list});
  setComponents(roles, data, path);
  if (isRowOfPictures(space, rows, data)) {
    std::erase_if(space, [&](int a) { return space.size() == 3 && data.sizes[std::size_t(a)] == 1; });
    data.spaceAxes = {space[0], space[1], rows[0]};
    data.poses.emplace();
  } else {
    require(space.size() == 3, "{} has {} dimensions, {} of them of space; a volume has 3, or 4 with time.",
            path.string(), data.sizes.size(), space.size());
    require(rows.size() <= 1, "{} has two axes of time; save one volume of it.", path.string());
    std::copy(space.begin(), space.end(), data.spaceAxes.begin());
    if (!rows.empty()) data.timeAxis = rows[0];
    if (!rows.empty())
      data.stored.timeSteps =
          int(std::clamp<std::int64_t>(data.sizes[std::size_t(rows[0])], -(1 << 20), 1 << 20));
  }
  setDims(data);
}

}  // namespace sonoskin
