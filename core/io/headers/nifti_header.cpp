// NIfTI-1 and NIfTI-2 headers, in one file with the voxels or in two.
#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/headers/axis_roles.h"
#include "core/io/headers/declared_data.h"
#include "core/io/headers/nifti_fields.h"
#include "core/io/headers/nifti_place.h"
#include "core/io/headers/unpacking.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

// By NIfTI's code; and the numbers per voxel.
void readType(const NiftiFields& f, DeclaredData& data, const fs::path& path) {
  static const std::map<int, std::pair<NumberType, int>> types{
      {2, {NumberType::uint8, 1}},     {256, {NumberType::int8, 1}},   {4, {NumberType::int16, 1}},
      {512, {NumberType::uint16, 1}},  {8, {NumberType::int32, 1}},    {768, {NumberType::uint32, 1}},
      {16, {NumberType::float32, 1}},  {64, {NumberType::float64, 1}}, {1024, {NumberType::int64, 1}},
      {1280, {NumberType::uint64, 1}}, {128, {NumberType::uint8, 3}},  {2304, {NumberType::uint8, 4}}};
  const auto found = types.find(f.datatype);
  require(found != types.end(),
          "{} has numbers of the type {}, which is not known here; save it with whole numbers or as float.",
          path.string(), f.datatype);
  data.type = data.stored.type = found->second.first;
  data.stored.components = found->second.second;
  // [nifti1.h, "DATA SCALING"]: a slope of 0 means none, whatever the intercept; colours have none.
  if (data.stored.components == 1 && std::isfinite(f.slope) && f.slope != 0)
    setScale(data, f.slope, f.intercept);
}

void readSizes(const NiftiFields& f, DeclaredData& data, const fs::path& path) {
  const std::int64_t dimensions = f.dim[0];
  require(dimensions >= 3 && dimensions <= 7, "{} has {} dimensions; a volume has 3, or 4 with time.",
          path.string(), dimensions);
  for (std::size_t n = 5; n <= std::size_t(dimensions); ++n)
    require(f.dim[n] == 1,
            "{} has more than one number per voxel, which is not known here; save one of them.",
            path.string());
  std::vector<AxisRole> roles;
  for (std::size_t n = 1; n <= std::size_t(std::min<std::int64_t>(dimensions, 4)); ++n) {
    data.sizes.push_back(f.dim[n]);
    roles.push_back(n < 4 ? AxisRole::space : AxisRole::time);
  }
  assignAxes(roles, data, path);
}

// name.img or name.img.gz beside name.hdr or name.hdr.gz.
fs::path imageBeside(const fs::path& path) {
  const std::string name = path.string();
  const std::size_t dot = name.rfind(".hdr");
  require(dot != std::string::npos && dot + 7 >= name.size(),
          "{} is the header of a NIfTI in two files; give them names that end in .hdr and .img.",
          path.string());
  for (const char* ending : {".img", ".img.gz"})
    if (const fs::path image = name.substr(0, dot) + ending; fs::exists(image)) return image;
  throw Error(
      fmt::format("{} is a NIfTI header without its voxels; put the .img file beside it.", path.string()));
}

}  // namespace

DeclaredData niftiData(const fs::path& path) {
  const NiftiFields f = niftiFields(path);
  DeclaredData data;
  readType(f, data, path);
  readSizes(f, data, path);
  placeNifti(f, data.stored, path);
  if (data.timeAxis < 0) data.stored.stepSeconds = 0;
  const fs::path file = f.inTwoFiles ? imageBeside(path) : path;
  const bool packed = isPacked(file);
  data.encoding = packed ? Encoding::packed : Encoding::raw;
  data.parts = {{file, packed ? 0 : std::uintmax_t(f.offset)}};
  data.bytesSkipped = packed ? std::uintmax_t(f.offset) : 0;
  data.bigEndian = f.swapped == (std::endian::native == std::endian::little);
  return data;
}

}  // namespace sonoskin
