#include "core/io/meshes/vtp_reader.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/header_text.h"
#include "core/io/meshes/frame_tag.h"
#include "core/io/meshes/polygon.h"
#include "core/io/meshes/vtp_arrays.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

class Reader {
 public:
  Reader(const fs::path& path, const Progress& progress)
      : path_(path), progress_(progress), file_(path, "PolyData") {}

  Mesh read() {
    std::size_t done = 0;
    for (const VtkPiece& piece : file_.pieces()) {
      progress_.update(double(done++) / double(file_.pieces().size()));
      addPiece(piece);
    }
    require(!mesh_.triangles.empty(), "{} holds no triangles; choose a file with a surface.", path_.string());
    if (leftOut_)
      log(LogLevel::warning, "The VTP file holds points or lines beside its surface; they are left out.");
    keepWhole();
    turnToLps(mesh_, frame());
    return std::move(mesh_);
  }

 private:
  void addPiece(const VtkPiece& piece) {
    const std::size_t base = mesh_.positions.size();
    addVectors(mesh_.positions, arrayOf(piece, "Points", ""), 1);
    const std::size_t points = mesh_.positions.size() - base;
    const auto stated = parseNumber<std::size_t>(piece.attributes.find("NumberOfPoints")->second);
    file_.check(!stated || *stated == points);
    for (const glm::vec3& p : mesh_.positions)
      require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z),
              "{} has a vertex at no finite position; get a fresh copy.", path_.string());
    addVectors(mesh_.normals, roleOf(piece, "Normals"), points);
    addNumbers(mesh_.visibility, arrayOf(piece, "PointData", "visibility"), points);
    addNumbers(mesh_.measured, arrayOf(piece, "PointData", "measured"), points);
    std::vector<float> labels;
    addNumbers(labels, arrayOf(piece, "PointData", "label"), points);
    for (const float label : labels)
      mesh_.labels.push_back(label >= 0 && label <= 255 ? std::uint8_t(label) : 0);
    if (const VtkArray* uvs = roleOf(piece, "TCoords"); uvs && uvs->components == 2)
      addNumbers(uvs_, uvs, 2 * points);
    addFaces(piece, "Polys", base, points);
    addFaces(piece, "Strips", base, points);
    for (const char* other : {"NumberOfVerts", "NumberOfLines"})
      leftOut_ = leftOut_ || parseNumber<double>(piece.attributes.find(other)->second).value_or(0) > 0;
  }

  // The first of a section where no name is given.
  static const VtkArray* arrayOf(const VtkPiece& piece, std::string_view section, std::string_view name) {
    for (const VtkArray& array : piece.arrays)
      if (array.section == section && (name.empty() || array.name == name)) return &array;
    return nullptr;
  }
  // That which the piece names for a role, or whose name is the role's.
  static const VtkArray* roleOf(const VtkPiece& piece, const std::string& role) {
    const auto named = piece.attributes.find("PointData." + role);
    return arrayOf(piece, "PointData", named == piece.attributes.end() ? role : named->second);
  }

  void addVectors(std::vector<glm::vec3>& to, const VtkArray* array, std::size_t least) {
    if (!array) return file_.check(&to != &mesh_.positions || least > 1);
    file_.check(array->components == 3);
    const std::vector<double> values = file_.numbers(*array);
    file_.check(values.size() % 3 == 0 && (&to == &mesh_.positions || values.size() == 3 * least));
    for (std::size_t i = 0; i < values.size(); i += 3)
      to.emplace_back(float(values[i]), float(values[i + 1]), float(values[i + 2]));
  }
  void addNumbers(std::vector<float>& to, const VtkArray* array, std::size_t count) {
    if (!array) return;
    const std::vector<double> values = file_.numbers(*array);
    file_.check(values.size() == count);
    for (const double v : values) to.push_back(float(v));
  }

  std::vector<std::size_t> indices(const VtkPiece& piece, const char* section, const char* name,
                                   std::size_t most) {
    std::vector<std::size_t> all;
    const VtkArray* array = arrayOf(piece, section, name);
    if (!array) return all;
    for (const double value : file_.numbers(*array)) {
      file_.check(value >= 0 && value <= double(most) && value == std::floor(value));
      all.push_back(std::size_t(value));
    }
    return all;
  }

  void addFaces(const VtkPiece& piece, const char* section, std::size_t base, std::size_t points) {
    if (points == 0) return;
    const auto corners = indices(piece, section, "connectivity", points - 1);
    const auto ends = indices(piece, section, "offsets", corners.size());
    std::vector<glm::vec3> places;
    std::size_t first = 0;
    for (const std::size_t end : ends) {
      file_.check(end >= first);
      const auto vertex = [&](std::size_t c) { return std::uint32_t(base + corners[first + c]); };
      if (std::string_view(section) == "Strips") {
        for (std::size_t i = 2; i < end - first; ++i)
          mesh_.triangles.push_back(
              {vertex(i % 2 ? i - 1 : i - 2), vertex(i % 2 ? i - 2 : i - 1), vertex(i)});
      } else {
        places.clear();
        for (std::size_t c = 0; c < end - first; ++c) places.push_back(mesh_.positions[vertex(c)]);
        for (const Triangle& t : splitPolygon(places))
          mesh_.triangles.push_back({vertex(t[0]), vertex(t[1]), vertex(t[2])});
      }
      first = end;
    }
  }

  // Lists that not all pieces have are of no use.
  void keepWhole() {
    const std::size_t n = mesh_.positions.size();
    const auto keep = [&](auto& list, std::size_t size) {
      if (list.size() != size) list.clear();
    };
    keep(mesh_.normals, n), keep(mesh_.visibility, n), keep(mesh_.measured, n), keep(mesh_.labels, n);
    keep(uvs_, 2 * n);
    if (uvs_.empty()) return;
    const auto uv = [&](std::uint32_t v) { return glm::vec2(uvs_[2 * v], uvs_[2 * v + 1]); };
    for (const auto& [a, b, c] : mesh_.triangles) mesh_.cornerUvs.push_back({uv(a), uv(b), uv(c)});
  }

  MeshFrame frame() const {
    for (const VtkArray& field : file_.fields()) {
      if (field.name != "SPACE") continue;
      std::string value;
      for (const double letter : file_.numbers(field))
        if (letter > 0 && letter < 128) value += char(letter);
      return frameNamed(trimmed(value));
    }
    return MeshFrame::lps;
  }

  const fs::path& path_;
  const Progress& progress_;
  VtkXmlFile file_;
  Mesh mesh_;
  std::vector<float> uvs_;
  bool leftOut_ = false;
};

}  // namespace

Mesh readVtp(const fs::path& path, const Progress& progress) { return Reader(path, progress).read(); }

}  // namespace sonoskin
