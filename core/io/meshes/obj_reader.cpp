#include "core/io/meshes/obj_reader.h"

#include <cstring>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/file_bytes.h"
#include "core/io/header_text.h"
#include "core/io/meshes/frame_tag.h"
#include "core/io/meshes/joined_mesh.h"
#include "core/io/meshes/polygon.h"
#include "core/io/meshes/text_words.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::uint32_t kNone = UINT32_MAX;

// Corner: indices from 0 of a polygon's corner; kNone where it has no such thing.
struct Corner {
  std::uint32_t place = kNone, uv = kNone, normal = kNone;
};

class ObjText {
 public:
  ObjText(std::string_view text, const fs::path& path, const Progress& progress)
      : lines_(text), size_(text.size()), path_(path), progress_(progress) {}

  Mesh read() {
    std::string joined;
    while (auto line = lines_.next()) {
      if (lines_.number() % 65536 == 0) progress_.update(0.7 * (1 - double(lines_.left()) / double(size_)));
      if (line->ends_with('\\')) line = goOn(*line, joined);
      readLine(*line);
    }
    if (left_)
      log(LogLevel::warning, "The OBJ file holds lines or points beside its surface; they are left out.");
    Mesh mesh = joinedFaces();
    turnToLps(mesh, frameIn(comments_));
    return mesh;
  }

 private:
  // A line that goes on in the next one.
  std::string_view goOn(std::string_view line, std::string& joined) {
    joined = line;
    while (joined.ends_with('\\')) {
      joined.back() = ' ';
      if (const auto next = lines_.next()) joined += *next;
    }
    return joined;
  }

  void readLine(std::string_view rest) {
    const std::string_view word = takeWord(rest);
    if (word.starts_with('#')) {
      if (comments_.size() < 65536) comments_.append(word).append(rest).append("\n");
    } else if (word == "v") {
      places_.push_back(vectorOf(rest, 3));
    } else if (word == "vn") {
      normals_.push_back(vectorOf(rest, 3));
    } else if (word == "vt") {
      uvs_.emplace_back(vectorOf(rest, 1));
    } else if (word == "f" || word == "fo") {
      readFace(rest);
    } else if (word == "l" || word == "p") {
      left_ = true;
    } else if (word == "surf" || word == "curv" || word == "curv2") {
      throw Error(
          fmt::format("{} holds free-form curves or surfaces, which are not read here; save it as triangles.",
                      path_.string()));
    }
  }

  // The first numbers of a line, `least` to three; what follows is a weight or a colour.
  glm::vec3 vectorOf(std::string_view rest, int least) {
    glm::vec3 v(0);
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = takeWord(rest);
      if (word.empty() && i >= least) break;
      const auto value = parseNumber<double>(word);
      if (!value) failInLine("holds no numbers of the form 1.5, with a point, where there should be some");
      v[i] = float(*value);
    }
    return v;
  }

  void readFace(std::string_view rest) {
    const std::size_t first = corners_.size();
    for (std::string_view word = takeWord(rest); !word.empty() && !word.starts_with('#');
         word = takeWord(rest))
      corners_.push_back(cornerOf(word));
    if (corners_.size() - first < 3) failInLine("has a face of fewer than three corners");
    faceEnds_.push_back(corners_.size());
  }

  // place, place/uv, place//normal or place/uv/normal.
  Corner cornerOf(std::string_view word) {
    Corner corner;
    const auto next = [&](std::size_t count) {
      const std::string_view part = word.substr(0, word.find('/'));
      word.remove_prefix(std::min(part.size() + 1, word.size()));
      return part.empty() ? kNone : indexOf(part, count);
    };
    corner.place = next(places_.size());
    corner.uv = next(uvs_.size());
    corner.normal = next(normals_.size());
    if (corner.place == kNone || !word.empty()) failInLine("has a face without vertices");
    return corner;
  }

  // From 1 on, or backward from the last one so far.
  std::uint32_t indexOf(std::string_view text, std::size_t count) {
    const auto index = parseNumber<std::int64_t>(text);
    const std::int64_t at = index ? (*index < 0 ? std::int64_t(count) + *index : *index - 1) : -1;
    if (at < 0 || at >= std::int64_t(kNone)) failInLine("has a face without vertices");
    return std::uint32_t(at);
  }

  // The places that faces use, in the order of the file.
  std::vector<std::uint32_t> joinedPlaces(JoinedMesh& mesh) const {
    std::vector<std::uint32_t> vertices(places_.size(), kNone);
    for (const Corner& c : corners_) {
      require(c.place < places_.size(), "{} has a triangle without vertices; get a fresh copy.",
              path_.string());
      vertices[c.place] = 0;
    }
    for (std::size_t v = 0; v < places_.size(); ++v)
      if (vertices[v] != kNone) vertices[v] = mesh.vertex(places_[v]);
    return vertices;
  }

  Mesh joinedFaces() {
    JoinedMesh mesh(path_);
    const std::vector<std::uint32_t> vertices = joinedPlaces(mesh);
    std::vector<glm::vec3> polygon;
    std::size_t first = 0;
    for (std::size_t f = 0; f < faceEnds_.size(); first = faceEnds_[f++]) {
      if (f % 65536 == 0) progress_.update(0.7 + 0.3 * double(f) / double(faceEnds_.size()));
      polygon.clear();
      for (std::size_t c = first; c < faceEnds_[f]; ++c) {
        polygon.push_back(places_[corners_[c].place]);
        if (corners_[c].normal < normals_.size()) mesh.vertex(polygon.back(), normals_[corners_[c].normal]);
      }
      for (const Triangle& t : splitPolygon(polygon)) addTriangle(mesh, vertices, first, t);
    }
    return mesh.take();
  }

  void addTriangle(JoinedMesh& mesh, const std::vector<std::uint32_t>& vertices, std::size_t first,
                   const Triangle& t) {
    const std::array<Corner, 3> corners{corners_[first + t[0]], corners_[first + t[1]],
                                        corners_[first + t[2]]};
    std::array<glm::vec2, 3> uvs;
    bool all = true;
    for (std::size_t i = 0; i < 3; ++i) {
      all = all && corners[i].uv < uvs_.size();
      if (all) uvs[i] = uvs_[corners[i].uv];
    }
    mesh.triangle({vertices[corners[0].place], vertices[corners[1].place], vertices[corners[2].place]},
                  all ? &uvs : nullptr);
  }

  [[noreturn]] void failInLine(const char* what) const {
    throw Error(fmt::format("{} {}, in line {}; get a fresh copy, or save it as PLY.", path_.string(), what,
                            lines_.number()));
  }

  TextLines lines_;
  std::size_t size_;
  const fs::path& path_;
  const Progress& progress_;
  std::vector<glm::vec3> places_, normals_;
  std::vector<glm::vec2> uvs_;
  std::vector<Corner> corners_;
  std::vector<std::size_t> faceEnds_;
  std::string comments_;
  bool left_ = false;
};

}  // namespace

Mesh readObj(const fs::path& path, const Progress& progress) {
  const std::vector<std::uint8_t> bytes = readBytes(path);
  return ObjText({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path, progress).read();
}

}  // namespace sonoskin
