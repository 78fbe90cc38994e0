// MetaImage headers (itk.org/Wiki/ITK/MetaIO/Documentation).
#include <array>

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/header_text.h"
#include "core/io/stored_volume.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

struct Meta {
  HeaderKeys keys;
  std::size_t bytes = 0;  // of the header: voxels of a local file follow
  bool ended = false;     // by ElementDataFile, the last key
};

Meta parse(std::string_view text) {
  Meta meta;
  HeaderLines lines(text);
  while (const auto line = lines.next()) {
    const std::size_t equals = line->find('=');
    if (equals == std::string_view::npos) return meta;
    const std::string key(trimmed(line->substr(0, equals)));
    meta.keys[key] = trimmed(line->substr(equals + 1));
    if (key == "ElementDataFile") {
      meta.bytes = lines.position();
      meta.ended = true;
      return meta;
    }
  }
  return meta;
}

// The value of the first of these keys that the header has; MetaIO gives several names to some.
std::string_view value(const Meta& meta, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names)
    if (const auto found = meta.keys.find(name); found != meta.keys.end()) return found->second;
  return {};
}

bool isTrue(std::string_view text) { return text == "1" || text.starts_with('T') || text.starts_with('t'); }

std::optional<NumberType> typeOf(std::string_view name) {
  if (name.ends_with("_ARRAY")) name.remove_suffix(6);
  static const std::map<std::string_view, NumberType> types{
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

// The numbers of a field; nothing if it is missing.
std::vector<double> numbers(std::string_view text, std::size_t count, std::string_view what,
                            const fs::path& path) {
  if (text.empty()) return {};
  const auto found = parseNumbers<double>(text);
  require(found && found->size() == count, "The {} in {} is not {} numbers; get a fresh copy.", what,
          path.string(), count);
  return *found;
}

void readSizes(const Meta& meta, std::size_t dimensions, const fs::path& path, StoredVolume& stored) {
  const auto sizes = parseNumbers<std::int64_t>(value(meta, {"DimSize"}));
  require(sizes && sizes->size() == dimensions, "The DimSize in {} is not {} numbers; get a fresh copy.",
          path.string(), dimensions);
  for (const std::int64_t size : *sizes)
    require(size >= 1 && size <= 65535,
            "{} says that it has {} voxels along one axis; 2 to 65535 are possible.", path.string(), size);
  for (int a = 0; a < 3; ++a) stored.geometry.dims[a] = int((*sizes)[std::size_t(a)]);
  if (dimensions == 4) stored.timeSteps = int((*sizes)[3]);
  const auto channels = value(meta, {"ElementNumberOfChannels"});
  const auto count = parseNumber<int>(channels.empty() ? "1" : channels);
  require(count && *count >= 1 && *count <= 65535,
          "{} does not say how many numbers a voxel has; get a fresh copy.", path.string());
  stored.components = *count;
}

void readPlace(const Meta& meta, std::size_t n, const fs::path& path, StoredVolume& stored) {
  Geometry& g = stored.geometry;
  const auto spacing = numbers(value(meta, {"ElementSpacing", "ElementSize"}), n, "spacing", path);
  const auto origin = numbers(value(meta, {"Offset", "Position", "Origin"}), n, "origin", path);
  const auto matrix =
      numbers(value(meta, {"TransformMatrix", "Orientation", "Rotation"}), n * n, "matrix", path);
  stored.spacingKnown = !spacing.empty();
  for (std::size_t a = 0; a < 3; ++a) {
    if (!spacing.empty()) g.spacing[int(a)] = spacing[a];
    if (!origin.empty()) g.origin[int(a)] = origin[a];
    // Each row of the file's matrix is the direction of one axis.
    for (std::size_t r = 0; r < 3 && !matrix.empty(); ++r) g.direction[int(a)][int(r)] = matrix[a * n + r];
  }
}

void placeData(const Meta& meta, const fs::path& path, StoredVolume& stored) {
  const std::string_view file = value(meta, {"ElementDataFile"});
  require(!lowerCase(file).starts_with("list") && file.find('%') == std::string_view::npos,
          "{} spreads its data over several files; save it as one .mha file.", path.string());
  const bool local = lowerCase(file) == "local";
  stored.dataFile = local ? path : besideHeader(path, file);
  stored.fileOffset = local ? meta.bytes : 0;
  if (isTrue(value(meta, {"CompressedData"})))
    stored.encoding = Encoding::deflate;
  else if (const auto binary = value(meta, {"BinaryData"}); !binary.empty() && !isTrue(binary))
    stored.encoding = Encoding::text;
  stored.bigEndian = isTrue(value(meta, {"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}));

  const auto skip = value(meta, {"HeaderSize"});
  const auto bytes = parseNumber<std::int64_t>(skip.empty() ? "0" : skip);
  require(bytes && *bytes >= -1, "{} has a HeaderSize that makes no sense; get a fresh copy.", path.string());
  if (*bytes > 0) stored.fileOffset = std::uintmax_t(*bytes);
  if (*bytes != -1) return;
  // -1: the voxels are the last bytes of the file. checkStored refuses what is too large for it.
  const std::uintmax_t size = fileSize(stored.dataFile);
  const std::uintmax_t voxels = stored.geometry.voxels() * std::uintmax_t(stored.timeSteps);
  const std::uintmax_t all = voxels * std::uintmax_t(stored.components) * numberTypeBytes(stored.type);
  require(stored.encoding == Encoding::raw, "{} has a HeaderSize of -1 but is not raw; save it again.",
          path.string());
  stored.fileOffset = all < size ? size - all : 0;
}

}  // namespace

StoredVolume readMetaHeader(const fs::path& path) {
  const std::string text = readHeaderText(path);
  const Meta meta = parse(text);
  require(meta.ended, "{} is not a complete MetaImage header; get a fresh copy.", path.string());
  const auto dimensions = parseNumber<int>(value(meta, {"NDims"}));
  require(dimensions && *dimensions >= 1 && *dimensions <= 10,
          "{} does not say how many dimensions it has; get a fresh copy.", path.string());
  require(*dimensions == 3 || *dimensions == 4, "{} has {} dimensions; a volume has 3, or 4 with time.",
          path.string(), *dimensions);
  StoredVolume stored;
  stored.format = "MetaImage";
  const std::string_view type = value(meta, {"ElementType"});
  require(typeOf(type).has_value(), "{} has numbers of the type \"{}\", which is not known here.",
          path.string(), type.substr(0, 20));
  stored.type = *typeOf(type);
  readSizes(meta, std::size_t(*dimensions), path, stored);
  readPlace(meta, std::size_t(*dimensions), path, stored);
  placeData(meta, path, stored);
  stored.beam = beamFromKeys(meta.keys);
  stored.unitRange = rangeFromKeys(meta.keys);
  return stored;
}

}  // namespace sonoskin
