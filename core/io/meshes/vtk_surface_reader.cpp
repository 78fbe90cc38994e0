#include "core/io/meshes/vtk_surface_reader.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/file_bytes.h"
#include "core/io/header_text.h"
#include "core/io/meshes/frame_tag.h"
#include "core/io/meshes/polygon.h"
#include "core/io/meshes/text_words.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

static_assert(std::endian::native == std::endian::little,
              "binary numbers are big-endian and are turned round");

template <class T>
double bigEndian(const char* at) {
  std::array<char, sizeof(T)> raw;
  std::reverse_copy(at, at + sizeof(T), raw.begin());
  return double(std::bit_cast<T>(raw));
}

struct Type {
  std::size_t bytes;
  double (*read)(const char*);
};

const Type* typeNamed(std::string_view name) {
  static const std::map<std::string_view, Type> kTypes{{"float", {4, bigEndian<float>}},
                                                       {"double", {8, bigEndian<double>}},
                                                       {"int", {4, bigEndian<std::int32_t>}},
                                                       {"long", {8, bigEndian<std::int64_t>}},
                                                       {"short", {2, bigEndian<std::int16_t>}},
                                                       {"vtktypeint32", {4, bigEndian<std::int32_t>}},
                                                       {"vtktypeint64", {8, bigEndian<std::int64_t>}}};
  const auto found = kTypes.find(name);
  return found == kTypes.end() ? nullptr : &found->second;
}

class Reader {
 public:
  Reader(std::string_view bytes, const fs::path& path) : bytes_(bytes), path_(path) {}

  Mesh read(const Progress& progress) {
    line();
    const MeshFrame frame = frameIn(line());
    isBinary_ = lowerCase(trimmed(line())) == "binary";
    for (std::string_view rest = line(); !ended_; rest = line()) {
      progress.throwIfCancelled();
      const std::string word = lowerCase(takeWord(rest));
      if (word == "points")
        readPoints(rest);
      else if (word == "polygons" || word == "triangle_strips" || word == "vertices" || word == "lines")
        readCells(word, rest);
      else if (word == "point_data" || word == "cell_data")
        break;  // what follows says nothing of the shape
    }
    if (leftOut_)
      log(LogLevel::warning, "The VTK file holds points or lines beside its surface; they are left out.");
    turnToLps(mesh_, frame);
    return std::move(mesh_);
  }

 private:
  std::string_view line() {
    ended_ = at_ >= bytes_.size();
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    std::string_view text = bytes_.substr(std::min(at_, end), end - std::min(at_, end));
    if (text.ends_with('\r')) text.remove_suffix(1);
    at_ = end + 1;
    return text;
  }

  void check(bool holds) const {
    require(
        holds,
        "{} is damaged or incomplete: its numbers are not what it says; get a fresh copy, or save it as PLY.",
        path_.string());
  }

  std::size_t count(std::string_view& rest) const {
    const auto value = parseNumber<std::size_t>(takeWord(rest));
    check(value && *value <= bytes_.size());
    return *value;
  }

  std::vector<double> numbers(std::size_t many, std::string_view typeName) {
    const Type* type = typeNamed(typeName);
    check(type != nullptr && at_ <= bytes_.size());
    check(many <= (bytes_.size() - at_) / (isBinary_ ? type->bytes : 1));
    std::vector<double> values;
    values.reserve(many);
    if (isBinary_) {
      for (; values.size() < many; at_ += type->bytes) values.push_back(type->read(bytes_.data() + at_));
      return values;
    }
    constexpr std::string_view kBlanks = " \t\r\n\v\f";
    while (values.size() < many) {
      const std::size_t begin = std::min(bytes_.find_first_not_of(kBlanks, at_), bytes_.size());
      const std::size_t end = std::min(bytes_.find_first_of(kBlanks, begin), bytes_.size());
      const auto value = parseNumber<double>(bytes_.substr(begin, end - begin));
      check(value.has_value());
      values.push_back(*value);
      at_ = end;
    }
    return values;
  }

  void readPoints(std::string_view rest) {
    const std::size_t many = count(rest);
    check(mesh_.positions.empty());
    const std::vector<double> values = numbers(3 * many, lowerCase(takeWord(rest)));
    for (std::size_t i = 0; i < values.size(); i += 3) {
      mesh_.positions.emplace_back(float(values[i]), float(values[i + 1]), float(values[i + 2]));
      const glm::vec3& p = mesh_.positions.back();
      require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z),
              "{} has a vertex at no finite position; get a fresh copy.", path_.string());
    }
  }

  // Before version 5: each cell's number of corners in front of them; since then offsets and corners by themselves.
  void readCells(const std::string& word, std::string_view rest) {
    const std::size_t cells = count(rest), size = count(rest);
    const std::size_t before = at_;
    std::string_view next = line();
    if (lowerCase(takeWord(next)) == "offsets") {
      const std::vector<double> offsets = numbers(cells, lowerCase(takeWord(next)));
      do next = line();
      while (!ended_ && trimmed(next).empty());
      check(lowerCase(takeWord(next)) == "connectivity");
      const std::vector<double> corners = numbers(size, lowerCase(takeWord(next)));
      for (std::size_t c = 0; c + 1 < offsets.size(); ++c) {
        check(offsets[c] >= 0 && offsets[c] <= offsets[c + 1] && offsets[c + 1] <= double(corners.size()));
        addCell(word, {corners.begin() + std::ptrdiff_t(offsets[c]),
                       corners.begin() + std::ptrdiff_t(offsets[c + 1])});
      }
      return;
    }
    at_ = before;
    const std::vector<double> all = numbers(size, "int");
    std::size_t at = 0;
    for (std::size_t c = 0; c < cells; ++c) {
      check(at < all.size() && all[at] >= 0 && all[at] <= double(all.size() - at - 1));
      const auto first = all.begin() + std::ptrdiff_t(at) + 1, last = first + std::ptrdiff_t(all[at]);
      addCell(word, {first, last});
      at += std::size_t(all[at]) + 1;
    }
  }

  void addCell(const std::string& word, const std::vector<double>& corners) {
    if (word == "vertices" || word == "lines") {
      leftOut_ = true;
      return;
    }
    std::vector<std::uint32_t> vertices;
    std::vector<glm::vec3> places;
    for (const double value : corners) {
      check(value >= 0 && value < double(mesh_.positions.size()) && value == std::floor(value));
      vertices.push_back(std::uint32_t(value));
      places.push_back(mesh_.positions[vertices.back()]);
    }
    if (word == "polygons") {
      for (const Triangle& t : splitPolygon(places))
        mesh_.triangles.push_back({vertices[t[0]], vertices[t[1]], vertices[t[2]]});
      return;
    }
    for (std::size_t i = 2; i < vertices.size(); ++i)
      mesh_.triangles.push_back(
          {vertices[i % 2 ? i - 1 : i - 2], vertices[i % 2 ? i - 2 : i - 1], vertices[i]});
  }

  std::string_view bytes_;
  const fs::path& path_;
  Mesh mesh_;
  std::size_t at_ = 0;
  bool isBinary_ = false, leftOut_ = false, ended_ = false;
};

}  // namespace

bool isVtkSurface(const fs::path& path) {
  std::error_code code;
  if (lowerExtension(path) != ".vtk" || !fs::is_regular_file(path, code) || fs::file_size(path, code) == 0)
    return false;
  const std::vector<std::uint8_t> start = readBytes(path, 1024);
  TextLines lines({reinterpret_cast<const char*>(start.data()), start.size()});
  for (auto text = lines.next(); text && lines.number() <= 6; text = lines.next()) {
    std::string_view rest = *text;
    if (lowerCase(takeWord(rest)) == "dataset") return lowerCase(takeWord(rest)) == "polydata";
  }
  return false;
}

Mesh readVtkSurface(const fs::path& path, const Progress& progress) {
  const std::vector<std::uint8_t> bytes = readBytes(path);
  return Reader({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path).read(progress);
}

}  // namespace sonoskin
