#include "core/io/meshes/ply_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/header_text.h"
#include "core/io/meshes/frame_tag.h"
#include "core/io/meshes/ply_header.h"
#include "core/io/meshes/polygon.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

static_assert(std::endian::native == std::endian::little, "numbers of big-endian files are turned round");

[[noreturn]] void failBody(const fs::path& path) {
  throw Error(fmt::format("{} is damaged or ends too early; get a fresh copy.", path.string()));
}

// The numbers of the body, one after another.
class Body {
 public:
  Body(std::string_view bytes, PlyFormat format, const fs::path& path)
      : bytes_(bytes), format_(format), path_(path) {}

  double next(PlyType type) { return format_ == PlyFormat::text ? nextText() : nextBinary(type); }
  std::size_t left() const { return bytes_.size() - at_; }
  // least: the fewest bytes that a number can take.
  std::size_t least(PlyType type) const { return format_ == PlyFormat::text ? 1 : bytesOf(type); }

 private:
  double nextText() {
    while (at_ < bytes_.size() && isBlank(bytes_[at_])) ++at_;
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && !isBlank(bytes_[at_])) ++at_;
    const auto value = parseNumber<double>(bytes_.substr(begin, at_ - begin));
    if (!value) failBody(path_);
    return *value;
  }
  double nextBinary(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return take<std::int8_t>();
      case PlyType::uint8:
        return take<std::uint8_t>();
      case PlyType::int16:
        return take<std::int16_t>();
      case PlyType::uint16:
        return take<std::uint16_t>();
      case PlyType::int32:
        return take<std::int32_t>();
      case PlyType::uint32:
        return take<std::uint32_t>();
      case PlyType::float32:
        return double(take<float>());
      case PlyType::float64:
        return take<double>();
    }
    return 0;
  }
  template <class T>
  T take() {
    if (left() < sizeof(T)) failBody(path_);
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes_.data() + at_, sizeof(T));
    if (format_ == PlyFormat::big) std::reverse(raw.begin(), raw.end());
    at_ += sizeof(T);
    return std::bit_cast<T>(raw);
  }
  static bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  std::string_view bytes_;
  std::size_t at_ = 0;
  PlyFormat format_;
  const fs::path& path_;
};

// An element takes at least this many bytes each: a declared count beyond the file's end is refused at once.
void checkRoom(const PlyElement& element, const Body& body, const fs::path& path) {
  std::uint64_t each = 0;
  for (const PlyProperty& p : element.properties) each += body.least(p.count.value_or(p.type));
  if (element.count > body.left() / std::max<std::uint64_t>(each, 1)) failBody(path);
}

void skipProperty(const PlyProperty& property, Body& body) {
  if (!property.count) {
    body.next(property.type);
    return;
  }
  const double count = body.next(*property.count);
  for (double n = 0; n < count; ++n) body.next(property.type);
}

// The name of a vertex' property: texture coordinates go by several.
std::string_view usualName(const std::string& name) {
  if (name == "u" || name == "texture_u" || name == "texture_s") return "s";
  if (name == "v" || name == "texture_v" || name == "texture_t") return "t";
  return name;
}

// A label of another program may be anything: beyond a byte it says nothing to us.
std::uint8_t labelOf(float value) { return value >= 0 && value <= 255 ? std::uint8_t(value) : 0; }

void readVertices(const PlyElement& element, Body& body, Mesh& mesh, std::vector<glm::vec2>& uvs,
                  const fs::path& path, const Progress& progress) {
  static constexpr std::array<std::string_view, 11> kNames{"x",          "y", "z", "nx",    "ny",      "nz",
                                                           "visibility", "s", "t", "label", "measured"};
  std::vector<std::size_t> slots;  // where each property goes; kNames.size(): nowhere
  std::array<bool, kNames.size()> has{};
  for (const PlyProperty& p : element.properties) {
    const auto found = p.count ? kNames.end() : std::find(kNames.begin(), kNames.end(), usualName(p.name));
    slots.push_back(std::size_t(found - kNames.begin()));
    if (found != kNames.end()) has[slots.back()] = true;
  }
  require(has[0] && has[1] && has[2],
          "{} gives its vertices no places: x, y and z are not all there; get a fresh copy.", path.string());
  const bool normals = has[3] && has[4] && has[5];
  for (std::uint64_t v = 0; v < element.count; ++v) {
    if (v % 65536 == 0) progress.update(double(v) / double(element.count));
    std::array<float, kNames.size()> values{};
    for (std::size_t p = 0; p < slots.size(); ++p) {
      if (slots[p] == kNames.size())
        skipProperty(element.properties[p], body);
      else
        values[slots[p]] = float(body.next(element.properties[p].type));
    }
    mesh.positions.emplace_back(values[0], values[1], values[2]);
    if (normals) mesh.normals.emplace_back(values[3], values[4], values[5]);
    if (has[6]) mesh.visibility.push_back(values[6]);
    if (has[9]) mesh.labels.push_back(labelOf(values[9]));
    if (has[7] && has[8]) uvs.emplace_back(values[7], values[8]);
    if (has[10]) mesh.measured.push_back(std::clamp(values[10], 0.f, 1.f));
  }
}

// Polygons: the corners of faces, one face after another, split when all vertices are there: faces may come first.
struct Polygons {
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> ends;
};

void readPolygon(const PlyProperty& property, Body& body, Polygons& polygons, const fs::path& path) {
  const double count = body.next(*property.count);
  if (!(count >= 0) || count * double(body.least(property.type)) > double(body.left())) failBody(path);
  for (double n = 0; n < count; ++n) {
    const double value = body.next(property.type);
    if (!(value >= 0 && value <= double(UINT32_MAX)) || value != std::floor(value)) failBody(path);
    polygons.corners.push_back(std::uint32_t(value));
  }
  polygons.ends.push_back(polygons.corners.size());
}

// Strips of triangles, -1 between one and the next; every second triangle is turned.
void readStrips(const PlyProperty& property, Body& body, Polygons& polygons, const fs::path& path) {
  const double count = body.next(*property.count);
  if (!(count >= 0) || count * double(body.least(property.type)) > double(body.left())) failBody(path);
  std::vector<std::uint32_t> last;
  for (double n = 0; n < count; ++n) {
    const double value = body.next(property.type);
    if (!(value >= -1 && value <= double(UINT32_MAX)) || value != std::floor(value)) failBody(path);
    if (value < 0) {
      last.clear();
      continue;
    }
    last.push_back(std::uint32_t(value));
    const std::size_t i = last.size() - 1;
    if (i < 2 || last[i] == last[i - 1] || last[i - 1] == last[i - 2] || last[i] == last[i - 2]) continue;
    const bool turns = i % 2 == 1;
    polygons.corners.insert(polygons.corners.end(),
                            {last[turns ? i - 1 : i - 2], last[turns ? i - 2 : i - 1], last[i]});
    polygons.ends.push_back(polygons.corners.size());
  }
}

bool listsVertices(const PlyProperty& p) {
  return p.count && (p.name == "vertex_indices" || p.name == "vertex_index");
}

void readFaces(const PlyElement& element, Body& body, Polygons& polygons, const fs::path& path,
               const Progress& progress) {
  require(std::ranges::any_of(element.properties, listsVertices),
          "{} has faces that list no vertex_indices; save it anew as PLY, or as STL.", path.string());
  const bool strips = element.name == "tristrips";
  for (std::uint64_t f = 0; f < element.count; ++f) {
    if (f % 65536 == 0) progress.update(double(f) / double(element.count));
    for (const PlyProperty& p : element.properties) {
      if (!listsVertices(p))
        skipProperty(p, body);
      else if (strips)
        readStrips(p, body, polygons, path);
      else
        readPolygon(p, body, polygons, path);
    }
  }
}

void splitAll(const Polygons& polygons, Mesh& mesh, const fs::path& path) {
  std::vector<glm::vec3> corners;
  for (const std::uint32_t v : polygons.corners)
    require(v < mesh.positions.size(), "{} has a triangle without vertices; get a fresh copy.",
            path.string());
  std::size_t first = 0;
  for (const std::size_t end : polygons.ends) {
    corners.clear();
    for (std::size_t c = first; c < end; ++c) corners.push_back(mesh.positions[polygons.corners[c]]);
    for (const Triangle& t : splitPolygon(corners))
      mesh.triangles.push_back(
          {polygons.corners[first + t[0]], polygons.corners[first + t[1]], polygons.corners[first + t[2]]});
    first = end;
  }
}

void checkResult(const Mesh& mesh, const fs::path& path) {
  require(!mesh.positions.empty() && !mesh.triangles.empty(),
          "{} holds no triangles; choose a file with a surface.", path.string());
  for (const glm::vec3& p : mesh.positions)
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z),
            "{} has a vertex at no finite position; get a fresh copy.", path.string());
}

void setUvs(const std::vector<glm::vec2>& uvs, Mesh& mesh) {
  if (uvs.size() != mesh.positions.size()) return;
  for (const auto& [a, b, c] : mesh.triangles) mesh.cornerUvs.push_back({uvs[a], uvs[b], uvs[c]});
}

}  // namespace

Mesh readPly(const fs::path& path, const Progress& progress) {
  const std::vector<std::uint8_t> bytes = readBytes(path);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const PlyHeader header = parsePlyHeader(text, path);
  Body body(text.substr(header.bytes), header.format, path);
  Mesh mesh;
  Polygons polygons;
  std::vector<glm::vec2> uvs;
  for (const PlyElement& element : header.elements) {
    checkRoom(element, body, path);
    if (element.name == "vertex")
      readVertices(element, body, mesh, uvs, path, progress.part(0, 0.5));
    else if (element.name == "face" || element.name == "tristrips")
      readFaces(element, body, polygons, path, progress.part(0.5, 0.9));
    else
      for (std::uint64_t n = 0; n < element.count; ++n)
        for (const PlyProperty& p : element.properties) skipProperty(p, body);
  }
  splitAll(polygons, mesh, path);
  checkResult(mesh, path);
  setUvs(uvs, mesh);
  turnToLps(mesh, frameIn(header.comments));
  return mesh;
}

}  // namespace sonoskin
