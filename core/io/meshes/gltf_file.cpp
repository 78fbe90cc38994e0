#include "core/io/meshes/gltf_file.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/file_bytes.h"
#include "core/io/header_text.h"
#include "core/io/meshes/base64.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

std::uint32_t wordAt(std::span<const std::uint8_t> bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

// Those that GltfNumbers and readGltf follow, and those of light and colour.
bool isKnown(const std::string& name) {
  static constexpr std::array<std::string_view, 3> kFollowed{
      "KHR_mesh_quantization", "KHR_draco_mesh_compression", "EXT_meshopt_compression"};
  static constexpr std::array<std::string_view, 7> kColours{"KHR_materials_", "KHR_texture_", "EXT_texture_",
                                                            "MSFT_texture_",  "KHR_lights_",  "EXT_lights_",
                                                            "KHR_xmp"};
  return std::ranges::count(kFollowed, name) > 0 ||
         std::ranges::any_of(kColours, [&](std::string_view start) { return name.starts_with(start); });
}

// Those that would repeat, hide or replace surfaces, such as EXT_mesh_gpu_instancing.
bool placesSurfaces(const std::string& name) {
  return std::ranges::any_of(std::array{"_mesh", "_node", "_lod"},
                             [&](const char* part) { return name.find(part) != std::string::npos; });
}

// The names that are told of, as the registry of glTF has them; any other text may be a person's name.
std::string forPeople(const std::string& name) {
  static constexpr std::array<std::string_view, 8> kNames{
      "EXT_mesh_features",     "EXT_mesh_gpu_instancing", "EXT_mesh_manifold", "FB_ngon_encoding",
      "KHR_animation_pointer", "KHR_gaussian_splatting",  "MSFT_lod",          "KHR_node_visibility"};
  return std::ranges::count(kNames, name) > 0 ? name : "an extension";
}

// "%20" and the like.
std::string decoded(const std::string& uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned value = 0;
    if (uri[i] == '%' && i + 2 < uri.size() &&
        std::from_chars(uri.data() + i + 1, uri.data() + i + 3, value, 16).ptr == uri.data() + i + 3) {
      text += char(value);
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

}  // namespace

GltfFile::GltfFile(const fs::path& path) : path_(path) {
  const std::vector<std::uint8_t> bytes = readBytes(path);
  most_ = bytes.size();
  try {
    parse(bytes);
  } catch (const json::exception&) {
    check(false);
  }
}

void GltfFile::check(bool holds) const {
  require(holds,
          "{} is damaged or incomplete: it is no whole glTF file; get a fresh copy, or save it as PLY.",
          path_.string());
}

// Its JSON, and the first piece behind it. [glTF 2.0, section 4]
void GltfFile::parse(std::span<const std::uint8_t> bytes) {
  constexpr std::uint32_t kJson = 0x4E4F534A, kBinary = 0x004E4942;
  constexpr std::size_t kHead = 12, kPieceHead = 8;
  std::span<const std::uint8_t> text = bytes, binary;
  if (bytes.size() >= kHead && !std::memcmp(bytes.data(), "glTF", 4)) {
    require(wordAt(bytes, 4) == 2,
            "{} is not of version 2 of glTF, the only one that is read here; save it anew.", path_.string());
    check(wordAt(bytes, 8) <= bytes.size());
    text = {};
    for (std::size_t at = kHead, end = wordAt(bytes, 8); at + kPieceHead <= end;) {
      const std::size_t length = wordAt(bytes, at);
      const std::uint32_t kind = wordAt(bytes, at + 4);
      at += kPieceHead;
      check(length <= end - at);
      if (kind == kJson && text.empty()) text = bytes.subspan(at, length);
      if (kind == kBinary && binary.empty()) binary = bytes.subspan(at, length);
      at += length;
    }
  }
  root_ = json::parse(text.begin(), text.end());
  check(root_.is_object());
  require(root_.at("asset").at("version").get<std::string>().starts_with("2."),
          "{} is not of version 2 of glTF, the only one that is read here; save it anew.", path_.string());
  requireKnownExtensions();
  loadBuffers(binary);
}

void GltfFile::requireKnownExtensions() const {
  if (root_.contains("extensionsUsed"))
    for (const json& entry : root_["extensionsUsed"])
      if (const std::string name = entry.get<std::string>(); !isKnown(name) && placesSurfaces(name))
        log(LogLevel::warning,
            fmt::format("The glTF file uses {} of glTF that is not known here; it is read without.",
                        forPeople(name)));
  if (!root_.contains("extensionsRequired")) return;
  for (const json& entry : root_["extensionsRequired"]) {
    const std::string name = entry.get<std::string>();
    require(isKnown(name), "{} needs {} of glTF that is not known here; save it without, or as PLY.",
            path_.string(), forPeople(name));
  }
}

void GltfFile::loadBuffers(std::span<const std::uint8_t> binary) {
  for (std::size_t b = 0; b < count("buffers"); ++b) {
    const json& buffer = item("buffers", b);
    const std::size_t length = number(buffer, "byteLength");
    std::vector<std::uint8_t> bytes;
    if (buffer.contains("uri"))
      bytes = fromUri(buffer["uri"].get<std::string>());
    else if (b == 0 && !binary.empty())
      bytes.assign(binary.begin(), binary.end());
    // Without a place it is a stand-in for what an extension keeps elsewhere: nothing can be read from it.
    const bool isStandIn = !buffer.contains("uri") && bytes.empty();
    check(isStandIn || bytes.size() >= length);
    if (!isStandIn) bytes.resize(length);
    most_ += buffer.contains("uri") ? bytes.size() : 0;
    buffers_.push_back(std::move(bytes));
  }
}

std::vector<std::uint8_t> GltfFile::fromUri(const std::string& uri) const {
  if (uri.starts_with("data:")) {
    const std::size_t comma = uri.find(',');
    check(comma != std::string::npos && uri.substr(0, comma).ends_with(";base64"));
    auto bytes = fromBase64(std::string_view(uri).substr(comma + 1));
    check(bytes.has_value());
    return std::move(*bytes);
  }
  const fs::path beside = besideHeader(path_, decoded(uri));
  std::error_code code;
  require(
      fs::is_regular_file(beside, code),
      "{} keeps its numbers in a file that is not beside it; put both into one folder, or save it as GLB.",
      path_.string());
  return readBytes(beside);
}

const json& GltfFile::item(const char* list, std::size_t index) const {
  check(index < count(list) && root_[list][index].is_object());
  return root_[list][index];
}

std::size_t GltfFile::count(const char* list) const {
  const auto found = root_.find(list);
  return found != root_.end() && found->is_array() ? found->size() : 0;
}

std::size_t GltfFile::number(const json& of, const char* member) const {
  const json& value = of.at(member);
  check(value.is_number_unsigned());
  return value.get<std::size_t>();
}

std::size_t GltfFile::number(const json& of, const char* member, std::size_t otherwise) const {
  return of.contains(member) ? number(of, member) : otherwise;
}

GltfFile::View GltfFile::bytesOf(const json& view) const {
  const std::size_t buffer = number(view, "buffer"), length = number(view, "byteLength"),
                    offset = number(view, "byteOffset", 0);
  check(buffer < buffers_.size());
  const std::vector<std::uint8_t>& bytes = buffers_[buffer];
  check(offset <= bytes.size() && length <= bytes.size() - offset);
  return {std::span(bytes).subspan(offset, length), number(view, "byteStride", 0)};
}

}  // namespace sonoskin
