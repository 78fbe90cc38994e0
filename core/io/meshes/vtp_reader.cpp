#include "core/io/meshes/vtp_reader.h"

#include <algorithm>
#include <cmath>
#include <span>

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
    if (misfit_)
      log(LogLevel::warning,
          "The VTP file holds an array of its points that is not of the size its name asks for (visibility, "
          "measured, label, normals or texture coordinates); it is left out.");
    keepWhole();
    turnToLps(mesh_, frame());
    return std::move(mesh_);
  }

 private:
  void addPiece(const VtkPiece& piece) {
    const std::size_t base = mesh_.positions.size();
    addVectors(mesh_.positions, placesOf(piece));
    const std::size_t points = mesh_.positions.size() - base;
    const auto stated = parseNumber<std::size_t>(piece.attributes.find("NumberOfPoints")->second);
    file_.check(!stated || *stated == points);
    for (const glm::vec3& p : std::span(mesh_.positions).subspan(base))
      require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z),
              "{} has a vertex at no finite position; get a fresh copy.", path_.string());
    addAttributes(piece, points);
    addFaces(piece, "Polys", base, points);
    addFaces(piece, "Strips", base, points);
    for (const char* other : {"NumberOfVerts", "NumberOfLines"})
      leftOut_ = leftOut_ || parseNumber<double>(piece.attributes.find(other)->second).value_or(0) > 0;
  }

  void addAttributes(const VtkPiece& piece, std::size_t points) {
    addVectors(mesh_.normals, fitting(roleOf(piece, "Normals"), 3, points));
    const auto add = [&](std::vector<float>& to, const VtkXmlArray* array, std::size_t components) {
      for (const double v : fitting(array, components, points)) to.push_back(float(v));
    };
    add(mesh_.visibility, arrayOf(piece, "PointData", "visibility"), 1);
    add(mesh_.measured, arrayOf(piece, "PointData", "measured"), 1);
    add(uvs_, roleOf(piece, "TCoords"), 2);
    for (const double label : fitting(arrayOf(piece, "PointData", "label"), 1, points))
      mesh_.labels.push_back(label >= 0 && label <= 255 ? std::uint8_t(label) : 0);
  }

  // The first of a section where no name is given.
  static const VtkXmlArray* arrayOf(const VtkPiece& piece, std::string_view section, std::string_view name) {
    for (const VtkXmlArray& array : piece.arrays)
      if (array.section == section && (name.empty() || array.name == name)) return &array;
    return nullptr;
  }
  // That which the piece names for a role, or whose name is the role's; an empty name says that there is
  // none.
  static const VtkXmlArray* roleOf(const VtkPiece& piece, const std::string& role) {
    const auto named = piece.attributes.find("PointData." + role);
    const std::string& name = named == piece.attributes.end() ? role : named->second;
    return name.empty() ? nullptr : arrayOf(piece, "PointData", name);
  }

  std::vector<double> placesOf(const VtkPiece& piece) const {
    const VtkXmlArray* array = arrayOf(piece, "Points", "");
    file_.check(array && array->components == 3);
    std::vector<double> values = file_.numbers(*array);
    file_.check(values.size() % 3 == 0);
    return values;
  }
  // The numbers of an array that a surface may have; none where it is something else under the same name.
  std::vector<double> fitting(const VtkXmlArray* array, std::size_t components, std::size_t points) {
    if (!array) return {};
    std::vector<double> values;
    if (array->components == components) values = file_.numbers(*array);
    if (values.size() == components * points) return values;
    misfit_ = true;
    return {};
  }
  static void addVectors(std::vector<glm::vec3>& to, const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); i += 3)
      to.emplace_back(float(values[i]), float(values[i + 1]), float(values[i + 2]));
  }

  std::vector<std::size_t> indices(const VtkPiece& piece, const char* section, const char* name,
                                   std::size_t most) {
    std::vector<std::size_t> all;
    const VtkXmlArray* array = arrayOf(piece, section, name);
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
    for (const VtkXmlArray& field : file_.fields()) {
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
  bool leftOut_ = false, misfit_ = false;
};

}  // namespace

Mesh readVtp(const fs::path& path, const Progress& progress) { return Reader(path, progress).read(); }

}  // namespace sonoskin
