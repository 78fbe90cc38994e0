// glTF 2.0 binary (registry.khronos.org/glTF/specs/2.0).
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/version.h"
#include "core/io/byte_sink.h"
#include "core/io/mesh_encoders.h"

namespace sonoskin {
namespace {

constexpr int kFloat = 5126, kUnsignedInt = 5125;            // component types
constexpr int kArrayBuffer = 34962, kElementBuffer = 34963;  // what a part of the buffer is for

using nlohmann::json;

// From LPS to the axes of glTF; a rotation, so triangles keep their winding.
glm::vec3 turned(const glm::vec3& v) { return {v.x, v.z, -v.y}; }

// The document while the buffer grows: each array becomes a buffer view and an accessor.
struct Document {
  json root;
  ByteSink buffer;

  template <class T>
  int add(const std::vector<T>& values, int component, const char* type, int target) {
    const std::size_t bytes = values.size() * sizeof(T);
    root["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes}, {"target", target}});
    const bool scalars = std::string_view(type) == "SCALAR";
    const std::size_t count = scalars ? bytes / 4 : values.size();
    root["accessors"].push_back({{"bufferView", root["bufferViews"].size() - 1},
                                 {"componentType", component},
                                 {"count", count},
                                 {"type", type}});
    buffer.array(values);
    return int(root["accessors"].size()) - 1;
  }
};

json material() {
  return {
      {"name", "skin"},
      {"doubleSided", true},
      {"pbrMetallicRoughness",
       {{"baseColorFactor", {0.78, 0.53, 0.42, 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.55}}}};
}

Document document(const Mesh& mesh) {
  Document d;
  d.root["asset"] = {{"version", "2.0"}, {"generator", std::string("Sonoskin ") + kVersion}};
  std::vector<glm::vec3> positions, normals;
  for (const glm::vec3& p : mesh.positions) positions.push_back(0.001f * turned(p));
  for (const glm::vec3& n : mesh.normals) normals.push_back(turned(n));
  const int position = d.add(positions, kFloat, "VEC3", kArrayBuffer);
  const Box box = boundingBox(positions);
  d.root["accessors"][0]["min"] = {box.min.x, box.min.y, box.min.z};
  d.root["accessors"][0]["max"] = {box.max.x, box.max.y, box.max.z};
  json attributes{{"POSITION", position}, {"NORMAL", d.add(normals, kFloat, "VEC3", kArrayBuffer)}};
  if (!mesh.visibility.empty())
    attributes["_VISIBILITY"] = d.add(mesh.visibility, kFloat, "SCALAR", kArrayBuffer);
  const int indices = d.add(mesh.triangles, kUnsignedInt, "SCALAR", kElementBuffer);
  d.root["materials"] = json::array({material()});
  d.root["meshes"] = json::array(
      {{{"primitives", json::array({{{"attributes", attributes}, {"indices", indices}, {"material", 0}}})}}});
  d.root["nodes"] = json::array({{{"mesh", 0}, {"name", "surface"}}});
  d.root["scenes"] = json::array({{{"nodes", {0}}}});
  d.root["scene"] = 0;
  d.root["buffers"] = json::array({{{"byteLength", d.buffer.size()}}});
  return d;
}

}  // namespace

Bytes encodeGlb(const Mesh& mesh) {
  if (mesh.normals.empty()) {
    Mesh withNormals = mesh;
    computeNormals(withNormals);
    return encodeGlb(withNormals);
  }
  Document d = document(mesh);
  std::string text = d.root.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::size_t total = 12 + 8 + text.size() + 8 + d.buffer.size();
  require(total <= UINT32_MAX, "The surface is too large for a GLB file; write PLY instead.");
  ByteSink out(total);
  out.text("glTF");
  out.number(std::uint32_t(2));
  out.number(std::uint32_t(total));
  out.number(std::uint32_t(text.size()));
  out.text("JSON");
  out.text(text);
  out.number(std::uint32_t(d.buffer.size()));  // a multiple of 4: all its numbers have four bytes
  out.text(std::string_view("BIN\0", 4));
  out.array(d.buffer.take());
  return out.take();
}

}  // namespace sonoskin
