#include "core/io/meshes/stl_reader.h"

#include <cstring>
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

constexpr std::size_t kHead = 80, kFirst = 84, kEach = 50;

std::uint64_t declaredTriangles(std::string_view bytes) {
  std::uint32_t count = 0;
  if (bytes.size() >= kFirst) std::memcpy(&count, bytes.data() + kHead, sizeof count);
  return count;
}

// A text begins with "solid"; so do some binary files, which have bytes that no text has, or just as many as they say.
bool isText(std::string_view bytes) {
  std::string_view line = bytes.substr(0, 1024);
  if (line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
  const std::size_t begin = line.find_first_not_of(" \t\r\n\v\f");
  if (begin == std::string_view::npos || lowerCase(line.substr(begin, 5)) != "solid") return false;
  if (bytes.size() >= kFirst && bytes.size() == kFirst + kEach * declaredTriangles(bytes)) return false;
  return line.find('\0') == std::string_view::npos;
}

Mesh readBinary(std::string_view bytes, const fs::path& path, const Progress& progress) {
  const std::uint64_t count = declaredTriangles(bytes);
  require(bytes.size() >= kFirst && count <= (bytes.size() - kFirst) / kEach,
          "{} ends before all of its triangles; the copy is incomplete, get a fresh one.", path.string());
  if (count > 0 && bytes.size() > kFirst + kEach * count)
    log(LogLevel::warning, "The STL file goes on behind the triangles that it counts; the rest is left out.");
  JoinedMesh mesh(path);
  for (std::uint64_t t = 0; t < count; ++t) {
    if (t % 65536 == 0) progress.update(double(t) / double(count));
    std::array<glm::vec3, 3> corners;
    std::memcpy(corners.data(), bytes.data() + kFirst + kEach * t + sizeof(glm::vec3), sizeof corners);
    mesh.triangle({mesh.vertex(corners[0]), mesh.vertex(corners[1]), mesh.vertex(corners[2])});
  }
  return mesh.take();
}

// The text, one line after another: words may stand in lines as they like.
class TextReader {
 public:
  TextReader(std::string_view text, const fs::path& path, const Progress& progress)
      : lines_(text), size_(text.size()), path_(path), progress_(progress), mesh_(path) {}

  Mesh read() {
    while (const auto line = lines_.next()) {
      if (lines_.number() % 65536 == 0) progress_.update(1 - double(lines_.left()) / double(size_));
      readLine(*line);
    }
    require(corners_.empty() && !insideLoop_,
            "{} ends in the middle of a triangle; the copy is incomplete, get a fresh one.", path_.string());
    if (insideSolid_)
      log(LogLevel::warning, "The STL text ends without its last line; the copy may be incomplete.");
    return mesh_.take();
  }
  const std::string& names() const { return names_; }

 private:
  void readLine(std::string_view rest) {
    for (std::string word = lowerCase(takeWord(rest)); !word.empty(); word = lowerCase(takeWord(rest))) {
      if (word == "solid" || word == "endsolid") {
        insideSolid_ = word == "solid";
        if (insideSolid_ && names_.size() < 4096) names_.append(rest).append("\n");
        return;  // the rest of the line is its name
      }
      if (word == "vertex")
        readVertex(rest);
      else if (word == "outer" || word == "endloop" || word == "endfacet")
        turnLoop(word);
      else if (word == "facet")
        for (int i = 0; i < 4; ++i)
          takeWord(rest);  // "normal" and the flat triangle's own, which is of no use here
      else if (word == "color" || word == "attribute" || word.starts_with('#'))
        return;
      else if (word != "loop")
        fail();
    }
  }

  void readVertex(std::string_view& rest) {
    glm::vec3 place;
    for (int i = 0; i < 3; ++i) {
      const auto value = parseNumber<double>(takeWord(rest));
      if (!value) fail();
      place[i] = float(*value);
    }
    if (!insideLoop_) fail();
    corners_.push_back(place);
  }

  void turnLoop(const std::string& word) {
    const bool begins = word == "outer";
    if (word == "endfacet" ? insideLoop_ : begins == insideLoop_) fail();
    insideLoop_ = begins;
    if (begins || word == "endfacet") return;
    if (corners_.size() < 3) fail();
    std::vector<std::uint32_t> vertices;
    for (const glm::vec3& corner : corners_) vertices.push_back(mesh_.vertex(corner));
    for (const Triangle& t : splitPolygon(corners_))
      mesh_.triangle({vertices[t[0]], vertices[t[1]], vertices[t[2]]});
    corners_.clear();
  }

  [[noreturn]] void fail() const {
    throw Error(fmt::format("{} is no STL text in line {}; get a fresh copy, or save it as binary STL.",
                            path_.string(), lines_.number()));
  }

  TextLines lines_;
  std::size_t size_;
  const fs::path& path_;
  const Progress& progress_;
  JoinedMesh mesh_;
  std::vector<glm::vec3> corners_;
  std::string names_;
  bool insideLoop_ = false, insideSolid_ = false;
};

}  // namespace

Mesh readStl(const fs::path& path, const Progress& progress) {
  const std::vector<std::uint8_t> raw = readBytes(path);
  const std::string_view bytes(reinterpret_cast<const char*>(raw.data()), raw.size());
  Mesh mesh;
  if (isText(bytes)) {
    TextReader reader(bytes, path, progress);
    mesh = reader.read();
    turnToLps(mesh, frameIn(reader.names()));
  } else {
    mesh = readBinary(bytes, path, progress);
    turnToLps(mesh, frameIn(bytes.substr(0, kHead)));
  }
  return mesh;
}

}  // namespace sonoskin
