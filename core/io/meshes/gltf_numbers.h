#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/io/meshes/gltf_file.h"

namespace sonoskin {

// GltfNumbers: what the accessors of a glTF file stand for: numbers of any type, apart by any stride, normalised or not,
// sparse ones too, in buffers as they are or packed by EXT_meshopt_compression. [glTF 2.0, section 3.6.2]
//   errors  of both: Error: damaged, or beyond the bytes that are there, which is looked at before memory is taken
class GltfNumbers {
 public:
  explicit GltfNumbers(const GltfFile& file) : file_(file) {}

  // floats: of an accessor of a type such as "VEC3", all components of the first element first.
  std::vector<float> floats(std::size_t accessor, const std::string& type);
  // indices: of an accessor of whole numbers.
  std::vector<std::uint32_t> indices(std::size_t accessor);

  // Shape: of the elements of an accessor: the type of a number, as the file has it, and how many there are.
  struct Shape {
    std::size_t type, components;
    bool isNormalised;
  };
  // Elements: as they lie in the file, `stride` bytes from one to the next, the first at the beginning.
  struct Elements {
    std::span<const std::uint8_t> bytes;
    std::size_t stride;
    Shape shape;
  };

 private:
  Elements elementsOf(const nlohmann::json& of, const Shape& shape, std::size_t count);
  template <class T>
  void replaceSome(std::vector<T>& values, const nlohmann::json& sparse, const Shape& shape);
  GltfFile::View viewOf(std::size_t index);
  template <class T>
  std::vector<T> numbers(std::size_t accessor, const std::string& type);

  const GltfFile& file_;
  std::map<std::size_t, std::vector<std::uint8_t>> unpacked_;
};

// componentsOf: how many numbers an element of a type has; 0 where there is no such type.
std::size_t componentsOf(const std::string& type);

}  // namespace sonoskin
