// MetaImage headers (itk.org/Wiki/ITK/MetaIO/Documentation).
#include <algorithm>

#include "core/base/error.h"
#include "core/io/declared_data.h"
#include "core/io/file_bytes.h"
#include "core/io/header_text.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMaxText = 200;  // MetaIO copies text of any length into 255 bytes

struct Meta {
  HeaderKeys keys;
  std::size_t bytes = 0;  // of the header: voxels of a local file follow
  std::string_view operator[](std::string_view name) const {
    const auto found = keys.find(name);
    return found == keys.end() ? std::string_view{} : std::string_view(found->second);
  }
};

// MetaIO ends a key at ':' too, and takes the last of two equal keys for some fields and the first for others.
bool plainKey(std::string_view key) {
  return !key.empty() && key.size() < kMaxText && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

Meta parse(std::string_view text, const fs::path& path) {
  Meta meta;
  HeaderLines lines(text, path);
  while (const auto line = lines.next()) {
    const std::size_t equals = line->find('=');
    if (equals == std::string_view::npos) break;
    const std::string key(trimmed(line->substr(0, equals)));
    const std::string_view value = trimmed(line->substr(equals + 1));
    require(plainKey(key) && value.size() <= kMaxText && meta.keys.emplace(key, value).second,
            "{} has a line \"{}\" that is too long, there twice or not known here; save it again without.",
            path.string(), key.substr(0, 20));
    if (key != "ElementDataFile") continue;
    meta.bytes = lines.position();
    return meta;
  }
  throw Error(fmt::format("{} is not a complete MetaImage header; get a fresh copy.", path.string()));
}

bool isTrue(std::string_view text) { return text == "1" || text.starts_with('T') || text.starts_with('t'); }

std::size_t typeBytes(std::string_view name) {
  static const std::map<std::string_view, std::size_t> bytes{
      {"MET_CHAR", 1},      {"MET_UCHAR", 1},      {"MET_SHORT", 2}, {"MET_USHORT", 2},
      {"MET_INT", 4},       {"MET_UINT", 4},       {"MET_LONG", 4},  {"MET_ULONG", 4},
      {"MET_LONG_LONG", 8}, {"MET_ULONG_LONG", 8}, {"MET_FLOAT", 4}, {"MET_DOUBLE", 8}};
  const auto found = bytes.find(name);
  return found == bytes.end() ? 0 : found->second;
}

// MetaIO reads as many numbers as it needs, from the next lines if need be.
void checkNumbers(const Meta& meta, std::initializer_list<const char*> keys, std::size_t count,
                  const char* what, const fs::path& path) {
  for (const char* key : keys) {
    const auto parts = words(meta[key]);
    require(!meta.keys.contains(key) ||
                (parts.size() == count && std::all_of(parts.begin(), parts.end(), isFinite)),
            "The {} in {} is not {} finite numbers; correct the header.", what, path.string(), count);
  }
}

void checkPlace(const Meta& meta, std::size_t n, const fs::path& path) {
  checkNumbers(meta, {"ElementSpacing", "ElementSize"}, n, "spacing", path);
  checkNumbers(meta, {"Offset", "Position", "Origin", "CenterOfRotation", "SequenceID"}, n, "origin", path);
  checkNumbers(meta, {"TransformMatrix", "Orientation", "Rotation"}, n * n, "direction of the axes", path);
  checkNumbers(meta, {"Color"}, 4, "colour", path);
  require(meta["AnatomicalOrientation"].size() <= n,
          "The orientation in {} is not one letter per axis; correct the header.", path.string());
}

void placePacked(const Meta& meta, bool local, const fs::path& path, DeclaredData& data) {
  data.encoding = Encoding::packed;
  const std::string_view size = meta["CompressedDataSize"];
  const auto bytes = parseNumber<std::int64_t>(size.empty() ? "0" : size);
  require(bytes && *bytes >= 0, "{} has a CompressedDataSize that makes no sense; get a fresh copy.",
          path.string());
  data.packedBytes = std::uintmax_t(*bytes);
  const std::uintmax_t left = fileSize(data.file) - std::min(fileSize(data.file), data.offset);
  // Without it, MetaIO takes the header for voxels.
  require(*bytes > 0 || !local || numbersIn(data) / 1032 > left,
          "{} does not say how many bytes its packed data have; save it again.", path.string());
}

void placeData(const Meta& meta, const fs::path& path, DeclaredData& data) {
  const std::string_view file = meta["ElementDataFile"];
  require(!lowerCase(file).starts_with("list") && file.find('%') == std::string_view::npos,
          "{} spreads its data over several files; save it as one .mha file.", path.string());
  const bool local = file == "LOCAL" || file == "Local" || file == "local";
  data.file = local ? path : besideHeader(path, file);
  data.offset = local ? meta.bytes : 0;
  const std::string_view binary = meta["BinaryData"], skip = meta["HeaderSize"];
  if (isTrue(meta["CompressedData"])) return placePacked(meta, local, path, data);
  if (!binary.empty() && !isTrue(binary)) data.encoding = Encoding::text;
  const auto bytes = parseNumber<std::int64_t>(skip.empty() ? "0" : skip);
  require(bytes && *bytes >= -1, "{} has a HeaderSize that makes no sense; get a fresh copy.", path.string());
  if (*bytes == -1) data.offset = 0;  // the voxels are the last bytes of the file
  if (*bytes > 0) data.offset = std::uintmax_t(*bytes);
}

}  // namespace

DeclaredData metaData(const fs::path& path) {
  const std::string text = readHeaderText(path);
  const Meta meta = parse(text, path);
  const auto dimensions = parseNumber<int>(meta["NDims"]);
  require(dimensions && *dimensions >= 1 && *dimensions <= 10,
          "{} does not say how many dimensions it has; get a fresh copy.", path.string());
  require(*dimensions == 3 || *dimensions == 4, "{} has {} dimensions; a volume has 3, or 4 with time.",
          path.string(), *dimensions);
  DeclaredData data;
  const auto sizes = parseNumbers<std::int64_t>(meta["DimSize"]);
  require(sizes && sizes->size() == std::size_t(*dimensions),
          "The DimSize in {} is not {} numbers; get a fresh copy.", path.string(), *dimensions);
  data.sizes = *sizes;
  data.bytesPerNumber = typeBytes(meta["ElementType"]);
  require(
      data.bytesPerNumber > 0,
      "{} has numbers of the type \"{}\", which is not known here; save it with whole numbers or as float.",
      path.string(), meta["ElementType"].substr(0, 20));
  const std::string_view channels = meta["ElementNumberOfChannels"];
  const auto components = parseNumber<int>(channels.empty() ? "1" : channels);
  require(components && *components >= 1 && *components <= 4,
          "{} has \"{}\" numbers per voxel; a volume has one, or three or four of colour.", path.string(),
          channels.substr(0, 20));
  data.components = *components;
  checkPlace(meta, data.sizes.size(), path);
  placeData(meta, path, data);
  data.spacingKnown = meta.keys.contains("ElementSpacing") || meta.keys.contains("ElementSize");
  return data;
}

}  // namespace sonoskin
