#include "core/io/meshes/three_mf_reader.h"

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/header_text.h"
#include "core/io/meshes/joined_mesh.h"
#include "core/io/meshes/three_mf_model.h"
#include "core/io/meshes/xml_elements.h"
#include "core/io/meshes/zip_file.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr int kMostDepth = 32;      // of objects in objects
constexpr int kMostUses = 1 << 20;  // of objects, each as often as it is put somewhere

// The name of the part that the file begins with.  [Open Packaging Conventions: relationships]
std::string rootPart(const ZipFile& zip, const fs::path& path) {
  std::string root = "3D/3dmodel.model";
  const auto relations = zip.part("_rels/.rels");
  if (!relations) return root;
  XmlEvents events;
  events.begin = [&](const XmlElement& e) {
    if (e.name() == "Relationship" && lowerCase(e.value("Type").value_or("")).ends_with("/3dmodel"))
      root = e.value("Target").value_or("");
  };
  events.end = [](std::string_view) {};
  walkXml(*relations, events, path);
  return root.starts_with('/') ? root.substr(1) : root;
}

class Builder {
 public:
  Builder(const fs::path& path, const Progress& progress)
      : path_(path), progress_(progress), zip_(path), root_(rootPart(zip_, path)), mesh_(path) {}

  Mesh build() {
    const ThreeMfModel& model = modelOf(root_);
    progress_.update(0.5);
    require(!model.items.empty(), "{} says of nothing that it is to be built; save it as plain triangles.",
            path_.string());
    for (const ThreeMfUse& item : model.items) put(item, root_, glm::dmat4(1), 0);
    if (leftOut_)
      log(LogLevel::warning,
          "The 3MF file holds supports or objects that are not to be built; they are left out.");
    return mesh_.take();
  }

 private:
  const ThreeMfModel& modelOf(const std::string& part) {
    if (const auto found = models_.find(part); found != models_.end()) return found->second;
    const auto xml = zip_.part(part);
    require(xml.has_value(), "{} has no part where it says that its model lies; get a fresh copy.",
            path_.string());
    return models_.emplace(part, parseThreeMf(*xml, path_)).first->second;
  }

  // An object where it is used, and with it what it is made of.
  void put(const ThreeMfUse& use, const std::string& inPart, const glm::dmat4& outer, int depth) {
    const std::string& part = use.part.empty() ? inPart : use.part;
    const ThreeMfModel& model = modelOf(part);
    const auto found = model.objects.find(use.object);
    require(found != model.objects.end(), "{} uses an object that it does not hold; get a fresh copy.",
            path_.string());
    require(depth < kMostDepth, "{} puts objects into objects without end; save it as plain triangles.",
            path_.string());
    require(++uses_ <= kMostUses,
            "{} puts more than {} objects into one another; save it as plain triangles.", path_.string(),
            kMostUses);
    const ThreeMfObject& object = found->second;
    if (!object.isBuilt) {
      leftOut_ = true;
      return;
    }
    require(model.millimetres == modelOf(root_).millimetres,
            "{} has parts in different units; save it as plain triangles.", path_.string());
    const glm::dmat4 place = outer * use.place;
    addTriangles(object, place, model.millimetres);
    for (const ThreeMfUse& component : object.components) put(component, part, place, depth + 1);
  }

  void addTriangles(const ThreeMfObject& object, const glm::dmat4& place, double millimetres) {
    const bool mirrors = glm::determinant(glm::dmat3(place)) < 0;
    std::vector<std::uint32_t> vertices(object.positions.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      if (v % 65536 == 0) progress_.throwIfCancelled();
      vertices[v] =
          mesh_.vertex(glm::vec3(millimetres * glm::dvec3(place * glm::dvec4(object.positions[v], 1))));
    }
    for (const Triangle& t : object.triangles) {
      require(std::max({t[0], t[1], t[2]}) < vertices.size(),
              "{} has a triangle without vertices; get a fresh copy.", path_.string());
      mesh_.triangle({vertices[t[0]], vertices[mirrors ? t[2] : t[1]], vertices[mirrors ? t[1] : t[2]]});
    }
  }

  const fs::path& path_;
  const Progress& progress_;
  ZipFile zip_;
  std::string root_;
  JoinedMesh mesh_;
  std::map<std::string, ThreeMfModel> models_;
  int uses_ = 0;
  bool leftOut_ = false;
};

}  // namespace

Mesh readThreeMf(const fs::path& path, const Progress& progress) { return Builder(path, progress).build(); }

}  // namespace sonoskin
