// NRRD headers (teem.sourceforge.net/nrrd/format.html).
#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/headers/data_files.h"
#include "core/io/headers/declared_data.h"
#include "core/io/headers/nrrd_fields.h"
#include "core/io/headers/nrrd_place.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

std::optional<NumberType> typeOf(std::string_view text) {
  std::string name = lowerCase(text);
  if (name.starts_with("signed ")) name.erase(0, 7);
  if (name.ends_with(" int") && name != "unsigned int") name.erase(name.size() - 4);
  static const std::map<std::string, NumberType, std::less<>> types{
      {"char", NumberType::int8},
      {"int8", NumberType::int8},
      {"int8_t", NumberType::int8},
      {"uchar", NumberType::uint8},
      {"unsigned char", NumberType::uint8},
      {"uint8", NumberType::uint8},
      {"uint8_t", NumberType::uint8},
      {"short", NumberType::int16},
      {"int16", NumberType::int16},
      {"int16_t", NumberType::int16},
      {"ushort", NumberType::uint16},
      {"unsigned short", NumberType::uint16},
      {"uint16", NumberType::uint16},
      {"uint16_t", NumberType::uint16},
      {"int", NumberType::int32},
      {"int32", NumberType::int32},
      {"int32_t", NumberType::int32},
      {"uint", NumberType::uint32},
      {"unsigned int", NumberType::uint32},
      {"uint32", NumberType::uint32},
      {"uint32_t", NumberType::uint32},
      {"longlong", NumberType::int64},
      {"long long", NumberType::int64},
      {"int64", NumberType::int64},
      {"int64_t", NumberType::int64},
      {"ulonglong", NumberType::uint64},
      {"unsigned long long", NumberType::uint64},
      {"uint64", NumberType::uint64},
      {"uint64_t", NumberType::uint64},
      {"float", NumberType::float32},
      {"double", NumberType::float64}};
  const auto found = types.find(name);
  if (found == types.end()) return {};
  return found->second;
}

std::vector<std::int64_t> sizesOf(const NrrdFields& nrrd, const fs::path& path) {
  const auto dimension = parseNumber<int>(nrrd["dimension"]);
  require(dimension && *dimension >= 1 && *dimension <= 16,
          "{} does not say how many dimensions it has; get a fresh copy.", path.string());
  const auto sizes = parseNumbers<std::int64_t>(nrrd["sizes"]);
  require(sizes && sizes->size() == std::size_t(*dimension),
          "The sizes in {}, of {} dimensions, are not as many numbers; get a fresh copy.", path.string(),
          *dimension);
  return *sizes;
}

Encoding encodingOf(const NrrdFields& nrrd, const fs::path& path) {
  static const std::map<std::string, Encoding, std::less<>> encodings{
      {"raw", Encoding::raw},     {"gzip", Encoding::packed}, {"gz", Encoding::packed},
      {"bzip2", Encoding::bzip2}, {"bz2", Encoding::bzip2},   {"txt", Encoding::text},
      {"text", Encoding::text},   {"ascii", Encoding::text},  {"hex", Encoding::hex}};
  const std::string name = lowerCase(nrrd["encoding"]);
  const auto found = encodings.find(name);
  require(found != encodings.end(), "{} has an encoding that is not known here; save it with gzip or raw.",
          path.string());
  return found->second;
}

void readByteOrder(const NrrdFields& nrrd, DeclaredData& data, const fs::path& path) {
  const std::string order = lowerCase(nrrd["endian"]);
  data.bigEndian = order == "big";
  require(order == "big" || order == "little" || data.encoding == Encoding::text ||
              numberTypeBytes(data.type) == 1,
          "{} does not say in which order the bytes of its numbers lie; add \"endian: little\" or \"endian: "
          "big\".",
          path.string());
}

void readSkips(const NrrdFields& nrrd, DeclaredData& data, const fs::path& path) {
  const auto number = [&](const char* field) {
    return parseNumber<std::int64_t>(nrrd[field].empty() ? "0" : nrrd[field]);
  };
  const auto lines = number("lineskip"), bytes = number("byteskip");
  require(lines && *lines >= 0, "{} has a line skip that makes no sense; correct the header.", path.string());
  require(bytes && (*bytes >= 0 || (*bytes == -1 && data.encoding == Encoding::raw)),
          "{} has a byte skip that its encoding does not allow; correct the header.", path.string());
  data.linesSkipped = *lines;
  data.bytesSkipped = std::uintmax_t(std::max<std::int64_t>(*bytes, 0));
  data.lastBytes = *bytes == -1;
}

// How many of the axes, from the fastest on, one file of several holds; the last number of the field, where
// it is there.
void checkParts(const DeclaredData& data, std::string_view subdim, const fs::path& path) {
  const auto given = parseNumber<std::size_t>(subdim);
  require(subdim.empty() || (given && *given >= 1 && *given <= data.sizes.size()),
          "{} gives its data files a number of dimensions that they cannot have; correct the header.",
          path.string());
  const std::size_t inEach = given.value_or(data.sizes.size() - 1);
  std::uint64_t files = 1;
  numbersIn(data, path);  // sizes are in range
  for (std::size_t a = inEach; a < data.sizes.size(); ++a) files *= std::uint64_t(data.sizes[a]);
  const bool slabs = inEach == data.sizes.size() && data.sizes.back() % std::int64_t(data.parts.size()) == 0;
  require(slabs || files == data.parts.size(),
          "{} names {} data files where {} are needed; correct the header.", path.string(), data.parts.size(),
          files);
}

void placeData(const NrrdFields& nrrd, DeclaredData& data, const fs::path& path) {
  const std::string_view file = nrrd["datafile"];
  std::vector<std::string> names = nrrd.files;
  const auto parts = words(file);
  const bool list = isFileList(file);
  if (isPattern(file)) names = namesOf(patternOf(file, path));
  if (list || isPattern(file)) {
    require(!names.empty(), "{} names no data files; correct the header.", path.string());
    for (const std::string& name : names) data.parts.push_back({besideHeader(path, name)});
    const std::size_t at = list ? 1 : 4;
    return checkParts(data, parts.size() > at ? parts[at] : std::string_view(), path);
  }
  require(!file.empty() || nrrd.ended, "{} ends within its header; get a fresh copy.", path.string());
  data.parts = {file.empty() ? DataPart{path, nrrd.bytes} : DataPart{besideHeader(path, file)}};
}

}  // namespace

DeclaredData nrrdData(const fs::path& path) {
  const std::string text = readHeaderText(path);
  const NrrdFields nrrd = parseNrrd(text, path);
  DeclaredData data;
  data.sizes = sizesOf(nrrd, path);
  const auto type = typeOf(nrrd["type"]);
  require(type.has_value(),
          "{} has numbers of a type that is not known here; save it with whole numbers or as float.",
          path.string());
  data.type = data.stored.type = *type;
  placeNrrd(nrrd, data, path);
  data.encoding = encodingOf(nrrd, path);
  readByteOrder(nrrd, data, path);
  readSkips(nrrd, data, path);
  placeData(nrrd, data, path);
  takeKeys(nrrd.keys, data, path);
  return data;
}

}  // namespace sonoskin
