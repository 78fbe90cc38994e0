// MetaImage headers (itk.org/Wiki/ITK/MetaIO/Documentation).
#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/file_bytes.h"
#include "core/io/headers/axis_roles.h"
#include "core/io/headers/data_files.h"
#include "core/io/headers/declared_data.h"
#include "core/io/headers/meta_fields.h"
#include "core/io/headers/meta_place.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

std::optional<NumberType> typeOf(std::string_view name) {
  static const std::map<std::string, NumberType, std::less<>> types{
      {"MET_CHAR", NumberType::int8},       {"MET_UCHAR", NumberType::uint8},
      {"MET_SHORT", NumberType::int16},     {"MET_USHORT", NumberType::uint16},
      {"MET_INT", NumberType::int32},       {"MET_UINT", NumberType::uint32},
      {"MET_LONG", NumberType::int32},      {"MET_ULONG", NumberType::uint32},
      {"MET_LONG_LONG", NumberType::int64}, {"MET_ULONG_LONG", NumberType::uint64},
      {"MET_FLOAT", NumberType::float32},   {"MET_DOUBLE", NumberType::float64}};
  const auto found = types.find(name);
  if (found == types.end()) return {};
  return found->second;
}

void readType(const MetaFields& meta, DeclaredData& data, const fs::path& path) {
  const auto type = typeOf(meta["ElementType"]);
  require(type.has_value(),
          "{} has an ElementType that is not known here; save it with whole numbers or as float.",
          path.string());
  data.type = data.stored.type = *type;
  const std::string_view channels = meta["ElementNumberOfChannels"];
  const auto components = parseNumber<int>(channels.empty() ? "1" : channels);
  require(components && (*components == 1 || *components == 3 || *components == 4),
          "The ElementNumberOfChannels of {} is none of 1, 3 and 4; save it with one number per voxel, or "
          "with three or four of colour.",
          path.string());
  data.stored.components = *components;
}

// [MetaIO, ElementToIntensityFunction]: intensity = slope * number + offset.
void readScale(const MetaFields& meta, DeclaredData& data) {
  const auto number = [&](const char* key, double otherwise) {
    return parseNumber<double>(meta[key]).value_or(otherwise);
  };
  setScale(data, number("ElementToIntensityFunctionSlope", 1), number("ElementToIntensityFunctionOffset", 0));
}

// Every program that writes both has the order of the element in mind, and so do those that read both.
void readByteOrder(const MetaFields& meta, DeclaredData& data) {
  const std::string_view element = meta["ElementByteOrderMSB"], binary = meta["BinaryDataByteOrderMSB"];
  data.bigEndian = metaIsTrue(element.empty() ? binary : element);
  if (!element.empty() && !binary.empty() && metaIsTrue(element) != metaIsTrue(binary))
    log(LogLevel::warning,
        "The header gives the order of bytes twice, and not the same; ElementByteOrderMSB holds.");
}

void readEncoding(const MetaFields& meta, DeclaredData& data, const fs::path& path) {
  const std::string_view binary = meta["BinaryData"], skip = meta["HeaderSize"];
  if (metaIsTrue(meta["CompressedData"]))
    data.encoding = Encoding::packed;
  else if (!binary.empty() && !metaIsTrue(binary))
    data.encoding = Encoding::text;
  const auto bytes = parseNumber<std::int64_t>(skip.empty() ? "0" : skip);
  require(bytes && *bytes >= -1 && (*bytes >= 0 || data.encoding == Encoding::raw),
          "{} has a HeaderSize that makes no sense; correct the header.", path.string());
  data.lastBytes = *bytes == -1;
  if (*bytes > 0)  // of the whole file, also where the header is a part of it
    for (DataPart& part : data.parts) part.offset = std::uintmax_t(*bytes);
  const std::string_view size = meta["CompressedDataSize"];
  const auto packed = parseNumber<std::int64_t>(size.empty() ? "0" : size);
  require(packed && *packed >= 0, "{} has a CompressedDataSize that makes no sense; get a fresh copy.",
          path.string());
  if (data.encoding == Encoding::packed && data.parts.size() == 1)
    data.parts[0].bytes = std::uintmax_t(*packed);
}

void placeParts(const MetaFields& meta, DeclaredData& data, const fs::path& path) {
  const std::string_view file = meta["ElementDataFile"];
  const std::string small = lowerCase(file);
  if (small == "local") {
    data.parts = {{path, meta.bytes}};
    return;
  }
  const bool list = isFileList(file);
  if (!list && !isPattern(file)) {
    data.parts = {{besideHeader(path, file)}};
    return;
  }
  const std::vector<std::string> names = list ? meta.files : namesOf(patternOf(file, path));
  for (const std::string& name : names) data.parts.push_back({besideHeader(path, name)});
  numbersIn(data, path);  // sizes are in range
  // "LIST 2D": how many of the axes a file holds; else all but the slowest.
  const auto parts = words(file);
  const std::size_t axes = data.sizes.size();
  const auto given = list && parts.size() > 1 ? parseNumber<std::size_t>(parts[1].substr(0, 1)) : axes - 1;
  require(given && *given >= 1 && *given < axes,
          "{} lists its data files in a way that is not known here; save it as one file.", path.string());
  std::uint64_t needed = 1;
  for (std::size_t a = *given; a < axes; ++a) needed *= std::uint64_t(data.sizes[a]);
  require(needed == data.parts.size(), "{} names {} data files where {} are needed; correct the header.",
          path.string(), data.parts.size(), needed);
}

std::vector<AxisRole> rolesOf(const MetaFields& meta, std::size_t axes, const fs::path& path) {
  std::vector<AxisRole> roles;
  for (const std::string_view kind : words(meta["Kinds"])) roles.push_back(roleOfKind(kind));
  require(roles.empty() || roles.size() == axes, "The Kinds in {} are not {} words; correct the header.",
          path.string(), axes);
  roles.resize(axes, AxisRole::unsaid);
  for (std::size_t a = 0; a < axes; ++a)
    if (roles[a] == AxisRole::unsaid) roles[a] = a < 3 ? AxisRole::space : AxisRole::time;
  return roles;
}

}  // namespace

DeclaredData metaData(const fs::path& path) {
  const std::string text = readHeaderText(path);
  const MetaFields meta = parseMeta(text, path);
  const auto dimensions = parseNumber<int>(meta["NDims"]);
  require(dimensions && *dimensions >= 1 && *dimensions <= 10,
          "{} does not say how many dimensions it has; get a fresh copy.", path.string());
  DeclaredData data;
  const auto sizes = parseNumbers<std::int64_t>(meta["DimSize"]);
  require(sizes && sizes->size() == std::size_t(*dimensions),
          "The DimSize in {} is not {} numbers; get a fresh copy.", path.string(), *dimensions);
  data.sizes = *sizes;
  readType(meta, data, path);
  assignAxes(rolesOf(meta, data.sizes.size(), path), data, path, placesManyFrames(meta.keys));
  placeMeta(meta, data, path);
  readScale(meta, data);
  readByteOrder(meta, data);
  placeParts(meta, data, path);
  readEncoding(meta, data, path);
  takeKeys(meta.keys, data, path);
  return data;
}

}  // namespace sonoskin
