#pragma once

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace sonoskin::test {

// GltfMaker: a glTF file put together piece by piece, by the standard's words and without our reader's code. It begins with
// one node that shows one mesh of one primitive.
struct GltfMaker {
  nlohmann::json root =
      nlohmann::json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
      "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {}}]}],
      "buffers": [], "bufferViews": [], "accessors": []})");
  std::string bytes;

  nlohmann::json& primitive() { return root["meshes"][0]["primitives"][0]; }
  nlohmann::json& node() { return root["nodes"][0]; }

  // view: the index of a bufferView of these bytes.
  std::size_t view(std::string_view data, std::size_t stride = 0) {
    nlohmann::json made{{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", data.size()}};
    if (stride > 0) made["byteStride"] = stride;
    bytes += data;
    bytes.resize((bytes.size() + 3) / 4 * 4);
    root["bufferViews"].push_back(made);
    return root["bufferViews"].size() - 1;
  }
  template <class T>
  static std::string bytesOf(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
  }
  // accessor: the index of one of numbers of a type, on a view.
  std::size_t accessor(std::size_t onView, int componentType, const char* type, std::size_t count) {
    root["accessors"].push_back(
        {{"bufferView", onView}, {"componentType", componentType}, {"type", type}, {"count", count}});
    return root["accessors"].size() - 1;
  }
  std::size_t floats(const std::vector<float>& values, const char* type, std::size_t components) {
    return accessor(view(bytesOf(values)), 5126, type, values.size() / components);
  }
  std::size_t indices(const std::vector<std::uint16_t>& values) {
    return accessor(view(bytesOf(values)), 5123, "SCALAR", values.size());
  }
  // glb: the whole in one file. [glTF 2.0, section 4]
  std::string glb() const {
    nlohmann::json whole = root;
    if (whole["buffers"].empty() && !bytes.empty())
      whole["buffers"].push_back({{"byteLength", bytes.size()}});
    std::string text = whole.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const auto word = [](std::size_t value) {
      std::string four(4, '\0');
      for (std::size_t b = 0; b < 4; ++b) four[b] = char(value >> (8 * b));
      return four;
    };
    const std::size_t binary = bytes.empty() ? 0 : 8 + bytes.size();
    std::string file =
        "glTF" + word(2) + word(12 + 8 + text.size() + binary) + word(text.size()) + "JSON" + text;
    if (binary > 0) file += word(bytes.size()) + std::string("BIN\0", 4) + bytes;
    return file;
  }
};

}  // namespace sonoskin::test
