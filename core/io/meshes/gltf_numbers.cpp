#include "core/io/meshes/gltf_numbers.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cstring>

namespace sonoskin {
namespace {

using nlohmann::json;

constexpr std::size_t kFloat = 5126, kMostStride = 1024;

std::size_t bytesOfType(std::size_t type) {
  switch (type) {
    case 5120:
    case 5121:
      return 1;
    case 5122:
    case 5123:
      return 2;
    case 5125:
    case 5126:
      return 4;
    default:
      return 0;
  }
}

template <class Stored, class T>
T takeAs(const std::uint8_t* at, bool isNormalised) {
  Stored value;
  std::memcpy(&value, at, sizeof value);
  if constexpr (std::is_same_v<T, float> && std::is_integral_v<Stored>)
    if (isNormalised) return std::max(float(value) / float(std::numeric_limits<Stored>::max()), -1.f);
  return T(value);
}

template <class T>
T take(const GltfNumbers::Elements& from, std::size_t element, std::size_t component) {
  const auto [type, components, isNormalised] = from.shape;
  const std::uint8_t* p = from.bytes.data() + element * from.stride + component * bytesOfType(type);
  switch (type) {
    case 5120:
      return takeAs<std::int8_t, T>(p, isNormalised);
    case 5121:
      return takeAs<std::uint8_t, T>(p, isNormalised);
    case 5122:
      return takeAs<std::int16_t, T>(p, isNormalised);
    case 5123:
      return takeAs<std::uint16_t, T>(p, isNormalised);
    case 5125:
      return takeAs<std::uint32_t, T>(p, isNormalised);
    default:
      if constexpr (std::is_same_v<T, float>) return takeAs<float, T>(p, false);
      return 0;
  }
}

// What EXT_meshopt_compression has packed; empty where it is damaged.
std::vector<std::uint8_t> unpack(const json& packing, std::span<const std::uint8_t> bytes, std::size_t count,
                                 std::size_t stride) {
  std::vector<std::uint8_t> out(count * stride);
  const std::string mode = packing.at("mode").get<std::string>(),
                    filter = packing.contains("filter") ? packing["filter"].get<std::string>() : "NONE";
  int fault = -1;
  if (mode == "ATTRIBUTES" && stride % 4 == 0 && stride > 0 && stride <= 256)
    fault = meshopt_decodeVertexBuffer(out.data(), count, stride, bytes.data(), bytes.size());
  else if (mode == "TRIANGLES" && count % 3 == 0 && (stride == 2 || stride == 4))
    fault = meshopt_decodeIndexBuffer(out.data(), count, stride, bytes.data(), bytes.size());
  else if (mode == "INDICES" && (stride == 2 || stride == 4))
    fault = meshopt_decodeIndexSequence(out.data(), count, stride, bytes.data(), bytes.size());
  if (fault != 0) return {};
  if (filter == "OCTAHEDRAL" && (stride == 4 || stride == 8))
    meshopt_decodeFilterOct(out.data(), count, stride);
  else if (filter == "QUATERNION" && stride == 8)
    meshopt_decodeFilterQuat(out.data(), count, stride);
  else if (filter == "EXPONENTIAL" && stride % 4 == 0)
    meshopt_decodeFilterExp(out.data(), count, stride);
  else if (filter != "NONE")
    return {};
  return out;
}

}  // namespace

std::size_t componentsOf(const std::string& type) {
  if (type == "SCALAR") return 1;
  if (type == "MAT4") return 16;
  return type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 0;
}

GltfFile::View GltfNumbers::viewOf(std::size_t index) {
  constexpr std::size_t kMostGrowth = 128;  // of the densest packing there is
  constexpr const char* kPacked = "EXT_meshopt_compression";
  const json& view = file_.item("bufferViews", index);
  if (!view.contains("extensions") || !view["extensions"].contains(kPacked)) return file_.bytesOf(view);
  const json& packing = view["extensions"][kPacked];
  const std::size_t count = file_.number(packing, "count"), stride = file_.number(packing, "byteStride");
  const auto [found, isNew] = unpacked_.try_emplace(index);
  if (isNew) {
    const std::span<const std::uint8_t> bytes = file_.bytesOf(packing).bytes;
    file_.check(stride > 0 && stride <= 256 && count <= kMostGrowth * bytes.size() / stride);
    found->second = unpack(packing, bytes, count, stride);
    file_.check(!found->second.empty());
  }
  return {found->second, file_.number(view, "byteStride", 0)};
}

GltfNumbers::Elements GltfNumbers::elementsOf(const json& of, const Shape& shape, std::size_t count) {
  const GltfFile::View view = viewOf(file_.number(of, "bufferView"));
  const std::size_t offset = file_.number(of, "byteOffset", 0),
                    size = shape.components * bytesOfType(shape.type),
                    stride = view.stride > 0 ? view.stride : size;
  file_.check(size > 0 && offset <= view.bytes.size() && stride <= kMostStride);
  const auto bytes = view.bytes.subspan(offset);
  file_.check(count == 0 || (size <= bytes.size() && count - 1 <= (bytes.size() - size) / stride));
  return {bytes, stride, shape};
}

// Others in some places. [glTF 2.0, section 3.6.2.3]
template <class T>
void GltfNumbers::replaceSome(std::vector<T>& values, const json& sparse, const Shape& shape) {
  const std::size_t count = file_.number(sparse, "count");
  const json& indices = sparse.at("indices");
  const Elements places = elementsOf(indices, {file_.number(indices, "componentType"), 1, false}, count);
  file_.check(places.shape.type != kFloat);
  const Elements from = elementsOf(sparse.at("values"), shape, count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t to = take<std::uint32_t>(places, i, 0);
    file_.check(to < values.size() / shape.components);
    for (std::size_t c = 0; c < shape.components; ++c)
      values[to * shape.components + c] = take<T>(from, i, c);
  }
}

template <class T>
std::vector<T> GltfNumbers::numbers(std::size_t accessor, const std::string& type) {
  const json& a = file_.item("accessors", accessor);
  const std::size_t count = file_.number(a, "count");
  const Shape shape{file_.number(a, "componentType"), componentsOf(type),
                    a.contains("normalized") && a["normalized"].get<bool>()};
  file_.check(a.at("type").get<std::string>() == type && bytesOfType(shape.type) > 0 &&
              (std::is_same_v<T, float> || shape.type != kFloat));
  std::vector<T> values;
  if (a.contains("bufferView")) {
    const Elements from = elementsOf(a, shape, count);
    values.resize(count * shape.components);
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = take<T>(from, i / shape.components, i % shape.components);
  } else {  // zeros
    file_.check(shape.components > 0 && count <= file_.most() / shape.components);
    values.resize(count * shape.components);
  }
  if (a.contains("sparse")) replaceSome(values, a["sparse"], shape);
  return values;
}

std::vector<float> GltfNumbers::floats(std::size_t accessor, const std::string& type) {
  return numbers<float>(accessor, type);
}

std::vector<std::uint32_t> GltfNumbers::indices(std::size_t accessor) {
  return numbers<std::uint32_t>(accessor, "SCALAR");
}

}  // namespace sonoskin
