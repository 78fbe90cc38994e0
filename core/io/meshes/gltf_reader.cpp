#include "core/io/meshes/gltf_reader.h"

#include <numeric>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/meshes/gltf_nodes.h"
#include "core/io/meshes/gltf_primitive.h"
#include "core/io/meshes/joined_mesh.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

glm::dvec3 toLps(const glm::dvec3& v) { return {v.x, -v.z, v.y}; }

// How a surface's normals turn, whatever its transform does to lengths and angles.
glm::dmat3 normalMatrix(const glm::dmat3& m) {
  return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

class Scene {
 public:
  Scene(const fs::path& path, const Progress& progress)
      : file_(path), numbers_(file_), nodes_(placeGltfNodes(file_)), mesh_(path), progress_(progress) {}

  Mesh read() {
    for (std::size_t i = 0; i < nodes_.shown.size(); ++i) {
      progress_.update(double(i) / double(nodes_.shown.size()));
      const json& node = file_.item("nodes", nodes_.shown[i]);
      if (node.contains("mesh")) addNode(node, nodes_.world[nodes_.shown[i]]);
    }
    require(mesh_.triangles() > 0, "{} holds no triangles{}; choose a file with a surface.",
            file_.path().string(), leftOut_ ? ", but points or lines alone" : "");
    if (leftOut_)
      log(LogLevel::warning, "The glTF file holds points or lines beside its surface; they are left out.");
    return mesh_.take();
  }

 private:
  void addNode(const json& node, const glm::dmat4& world) {
    const json& mesh = file_.item("meshes", file_.number(node, "mesh"));
    std::vector<float> morph;
    for (const json* of : {&node, &mesh})
      if (morph.empty() && of->contains("weights")) morph = (*of)["weights"].get<std::vector<float>>();
    const std::vector<glm::dmat4> bones = bonesOf(node);
    for (const json& primitive : mesh.at("primitives")) {
      const GltfPrimitive part = readGltfPrimitive(file_, primitive, morph, numbers_);
      leftOut_ = leftOut_ || part.triangles.empty();
      addPart(part, bones, world);
    }
  }

  // Of a skeleton: from a mesh's frame to where each bone has moved it. [glTF 2.0, section 3.7.3.3]
  std::vector<glm::dmat4> bonesOf(const json& node) {
    std::vector<glm::dmat4> bones;
    if (!node.contains("skin")) return bones;
    const json& skin = file_.item("skins", file_.number(node, "skin"));
    for (const json& joint : skin.at("joints")) {
      file_.check(joint.is_number_unsigned() && joint.get<std::size_t>() < nodes_.world.size());
      bones.push_back(nodes_.world[joint.get<std::size_t>()]);
    }
    if (!skin.contains("inverseBindMatrices")) return bones;
    const std::vector<float> rest = numbers_.floats(file_.number(skin, "inverseBindMatrices"), "MAT4");
    file_.check(rest.size() >= 16 * bones.size());
    for (std::size_t b = 0; b < bones.size(); ++b) {
      glm::dmat4 inverse;
      for (std::size_t i = 0; i < 16; ++i) inverse[int(i / 4)][int(i % 4)] = rest[16 * b + i];
      bones[b] = bones[b] * inverse;
    }
    return bones;
  }

  // Where one vertex goes: with its bones, weighted, or with its node.
  glm::dmat4 placeOf(const GltfPrimitive& part, std::size_t v, const std::vector<glm::dmat4>& bones,
                     const glm::dmat4& world) const {
    if (bones.empty() || part.influences == 0) return world;
    glm::dmat4 sum(0);
    double total = 0;
    for (std::size_t s = 0; s < part.influences; ++s)
      for (int i = 0; i < 4; ++i) {
        const double weight = part.weights[s * part.positions.size() + v][i];
        const float joint = part.joints[s * part.positions.size() + v][i];
        if (!(weight > 0)) continue;
        file_.check(joint >= 0 && joint < float(bones.size()));
        sum += weight * bones[std::size_t(joint)];
        total += weight;
      }
    file_.check(total > 0);
    return sum / total;
  }

  void addPart(const GltfPrimitive& part, const std::vector<glm::dmat4>& bones, const glm::dmat4& world) {
    std::vector<std::uint32_t> vertices(part.positions.size());
    bool mirrors = false;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      if (v % 65536 == 0) progress_.throwIfCancelled();
      const glm::dmat4 place = placeOf(part, v, bones, world);
      if (v == 0) mirrors = glm::determinant(glm::dmat3(place)) < 0;
      const glm::dvec3 at(place * glm::dvec4(part.positions[v], 1));
      const double side = mirrors ? -1 : 1;  // normals stay outward
      const glm::dvec3 normal = part.normals.empty()
                                    ? glm::dvec3(0)
                                    : side * (normalMatrix(glm::dmat3(place)) * glm::dvec3(part.normals[v]));
      const double length = glm::length(normal);
      vertices[v] = mesh_.vertex(glm::vec3(1000.0 * toLps(at)),
                                 glm::vec3(length > 0 ? toLps(normal / length) : glm::dvec3(0)));
    }
    for (const Triangle& t : part.triangles) addTriangle(part, vertices, t, mirrors);
  }

  void addTriangle(const GltfPrimitive& part, const std::vector<std::uint32_t>& vertices, Triangle t,
                   bool mirrors) {
    if (mirrors) std::swap(t[1], t[2]);
    const Triangle corners{vertices[t[0]], vertices[t[1]], vertices[t[2]]};
    if (part.uvs.empty()) return mesh_.triangle(corners);
    const std::array<glm::vec2, 3> uvs{part.uvs[t[0]], part.uvs[t[1]], part.uvs[t[2]]};
    mesh_.triangle(corners, &uvs);
  }

  GltfFile file_;
  GltfNumbers numbers_;
  GltfNodes nodes_;
  JoinedMesh mesh_;
  const Progress& progress_;
  bool leftOut_ = false;
};

}  // namespace

Mesh readGltf(const fs::path& path, const Progress& progress) try {
  return Scene(path, progress).read();
} catch (const json::exception&) {  // a member is missing or of another kind
  throw Error(fmt::format(
      "{} is damaged or incomplete: it is no whole glTF file; get a fresh copy, or save it as PLY.",
      path.string()));
}

}  // namespace sonoskin
