#include "core/io/meshes/gltf_primitive.h"

#include <algorithm>
#include <numeric>

#include "core/io/meshes/gltf_draco.h"

namespace sonoskin {
namespace {

using nlohmann::json;

constexpr const char* kDraco = "KHR_draco_mesh_compression";
constexpr std::size_t kTriangles = 4, kStrip = 5, kFan = 6;

// Attributes: those of one primitive, wherever they are kept.
class Attributes {
 public:
  Attributes(const GltfFile& file, const json& primitive, GltfNumbers& numbers)
      : file_(file), primitive_(primitive), numbers_(numbers) {
    if (primitive.contains("extensions") && primitive["extensions"].contains(kDraco))
      draco_ = std::make_unique<GltfDraco>(file, primitive["extensions"][kDraco]);
  }

  bool isDraco() const { return draco_ != nullptr; }
  bool has(const std::string& name) const { return primitive_.at("attributes").contains(name); }

  template <class Vector>
  std::vector<Vector> read(const std::string& name) {
    constexpr std::size_t kComponents = sizeof(Vector) / sizeof(float);
    const std::vector<float> values =
        draco_ && draco_->has(name) ? draco_->floats(name, kComponents)
                                    : numbers_.floats(file_.number(primitive_.at("attributes"), name.c_str()),
                                                      "VEC" + std::to_string(kComponents));
    std::vector<Vector> vectors(values.size() / kComponents);
    for (std::size_t i = 0; i < values.size(); ++i)
      vectors[i / kComponents][int(i % kComponents)] = values[i];
    return vectors;
  }

  std::vector<std::uint32_t> indices(std::size_t vertices) {
    if (draco_) return draco_->indices();
    if (primitive_.contains("indices")) return numbers_.indices(file_.number(primitive_, "indices"));
    std::vector<std::uint32_t> all(vertices);
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }

 private:
  const GltfFile& file_;
  const json& primitive_;
  GltfNumbers& numbers_;
  std::unique_ptr<GltfDraco> draco_;
};

// Every second triangle of a strip is turned. [glTF 2.0, section 3.7.2.1]
std::vector<Triangle> trianglesOf(const std::vector<std::uint32_t>& indices, std::size_t mode) {
  std::vector<Triangle> triangles;
  const std::size_t step = mode == kTriangles ? 3 : 1;
  for (std::size_t i = 0; i + 2 < indices.size(); i += step) {
    if (mode == kFan)
      triangles.push_back({indices[0], indices[i + 1], indices[i + 2]});
    else if (mode == kStrip && i % 2 == 1)
      triangles.push_back({indices[i + 1], indices[i], indices[i + 2]});
    else
      triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
  }
  return triangles;
}

// What the targets add to places and normals.
void addTargets(const json& primitive, const std::vector<float>& morph, GltfNumbers& numbers,
                const GltfFile& file, GltfPrimitive& made) {
  if (!primitive.contains("targets")) return;
  const json& targets = primitive["targets"];
  for (std::size_t t = 0; t < std::min(targets.size(), morph.size()); ++t) {
    if (morph[t] == 0) continue;
    const auto add = [&](const char* name, std::vector<glm::vec3>& to) {
      if (to.empty() || !targets[t].contains(name)) return;
      const std::vector<float> moves = numbers.floats(file.number(targets[t], name), "VEC3");
      file.check(moves.size() == 3 * to.size());
      for (std::size_t i = 0; i < moves.size(); ++i) to[i / 3][int(i % 3)] += morph[t] * moves[i];
    };
    add("POSITION", made.positions);
    add("NORMAL", made.normals);
  }
}

void addInfluences(Attributes& attributes, const GltfFile& file, GltfPrimitive& made) {
  for (;; ++made.influences) {
    const std::string set = std::to_string(made.influences);
    if (!attributes.has("JOINTS_" + set) || !attributes.has("WEIGHTS_" + set)) return;
    const auto joints = attributes.read<glm::vec4>("JOINTS_" + set);
    const auto weights = attributes.read<glm::vec4>("WEIGHTS_" + set);
    file.check(joints.size() == made.positions.size() && weights.size() == joints.size());
    made.joints.insert(made.joints.end(), joints.begin(), joints.end());
    made.weights.insert(made.weights.end(), weights.begin(), weights.end());
  }
}

}  // namespace

GltfPrimitive readGltfPrimitive(const GltfFile& file, const json& primitive, const std::vector<float>& morph,
                                GltfNumbers& numbers) {
  GltfPrimitive made;
  const std::size_t mode = file.number(primitive, "mode", kTriangles);
  file.check(mode <= kFan);
  Attributes attributes(file, primitive, numbers);
  if (mode < kTriangles || !attributes.has("POSITION")) return made;
  made.positions = attributes.read<glm::vec3>("POSITION");
  if (attributes.has("NORMAL")) made.normals = attributes.read<glm::vec3>("NORMAL");
  if (attributes.has("TEXCOORD_0")) made.uvs = attributes.read<glm::vec2>("TEXCOORD_0");
  for (glm::vec2& uv : made.uvs) uv.y = 1 - uv.y;
  const std::size_t n = made.positions.size();
  file.check((made.normals.empty() || made.normals.size() == n) &&
             (made.uvs.empty() || made.uvs.size() == n));
  addTargets(primitive, morph, numbers, file, made);
  addInfluences(attributes, file, made);
  made.triangles = trianglesOf(attributes.indices(n), attributes.isDraco() ? kTriangles : mode);
  for (const Triangle& t : made.triangles) file.check(std::max({t[0], t[1], t[2]}) < n);
  return made;
}

}  // namespace sonoskin
