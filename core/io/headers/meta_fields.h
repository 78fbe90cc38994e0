#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/header_text.h"

namespace sonoskin {

// MetaFields: the header of a MetaImage, taken apart. Lines may have any length.
//   files  of "ElementDataFile = LIST"
struct MetaFields {
  HeaderKeys keys;
  std::vector<std::string> files;
  std::size_t bytes = 0;  // of the header: voxels of a local file follow

  bool has(std::string_view name) const { return keys.find(name) != keys.end(); }
  std::string_view operator[](std::string_view name) const {
    const auto found = keys.find(name);
    return found == keys.end() ? std::string_view{} : std::string_view(found->second);
  }
};

// parseMeta: of the text that a file begins with.
//   errors  Error: it does not come to the key ElementDataFile; a key is there twice, or is none that two
//           programs would read alike; what is no text
MetaFields parseMeta(std::string_view text, const std::filesystem::path& path);

bool metaIsTrue(std::string_view text);

}  // namespace sonoskin
