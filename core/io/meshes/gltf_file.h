#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace sonoskin {

// GltfFile: the JSON of a glTF 2.0 file and the bytes of its buffers, of GLB or of text with its buffers in it or in files
// beside it. Extensions that the file requires and that change its surface are known here, or the file is refused.
// [Khronos glTF 2.0]
class GltfFile {
 public:
  // errors  Error: damaged, incomplete, another version, an extension that is not known here, a buffer that is not there
  explicit GltfFile(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }
  const nlohmann::json& root() const { return root_; }
  // item: of one of the root's lists, such as "accessors".  errors  Error: there is none
  const nlohmann::json& item(const char* list, std::size_t index) const;
  std::size_t count(const char* list) const;

  // View: bytes of a buffer, and how far one element lies from the next; 0 where they are packed.
  struct View {
    std::span<const std::uint8_t> bytes;
    std::size_t stride = 0;
  };
  // bytesOf: what a bufferView, or an extension that has the same members, points to.
  View bytesOf(const nlohmann::json& view) const;
  // most: no list of the file has more elements, for each takes a byte or more somewhere.
  std::size_t most() const { return most_; }

  // check: refuses the file as damaged where something does not hold.
  void check(bool holds) const;
  // number: a whole number from 0 on, of a member; `otherwise` where there is none.
  std::size_t number(const nlohmann::json& of, const char* member) const;
  std::size_t number(const nlohmann::json& of, const char* member, std::size_t otherwise) const;

 private:
  void parse(std::span<const std::uint8_t> bytes);
  void requireKnownExtensions() const;
  void loadBuffers(std::span<const std::uint8_t> binary);
  std::vector<std::uint8_t> fromUri(const std::string& uri) const;

  std::filesystem::path path_;
  nlohmann::json root_;
  std::vector<std::vector<std::uint8_t>> buffers_;
  std::size_t most_ = 0;
};

}  // namespace sonoskin
