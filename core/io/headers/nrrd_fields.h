#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/header_text.h"

namespace sonoskin {

// NrrdFields: the header of a NRRD, taken apart.
//   fields  names in small letters without blanks, as some may be written in two ways
//   keys    keys with values of their own ("key:=value")
//   files   of "data file: LIST"
struct NrrdFields {
  HeaderKeys fields, keys;
  std::vector<std::string> files;
  std::size_t bytes = 0;  // of the header, with the empty line that ends it
  bool ended = false;     // by an empty line

  std::string_view operator[](std::string_view name) const {
    const auto found = fields.find(name);
    return found == fields.end() ? std::string_view{} : std::string_view(found->second);
  }
};

// parseNrrd: of the text that a file begins with.
//   errors  Error: a field is there twice; what is no text
NrrdFields parseNrrd(std::string_view text, const std::filesystem::path& path);

// quotedWords: of a field such as units: "mm" "mm" "", with or without the quotes.
std::vector<std::string> quotedWords(std::string_view text);

// NrrdVector: one of "space directions" or "space origin"; nothing for "none".
using NrrdVector = std::optional<std::vector<double>>;

// nrrdVectors: of a text such as (1,0,0) none (0,0,1).
//   errors  Error: it is no row of vectors of finite numbers
std::vector<NrrdVector> nrrdVectors(std::string_view text, const std::filesystem::path& path);

}  // namespace sonoskin
