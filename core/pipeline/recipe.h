#pragma once

#include <string>

#include "core/base/hash.h"
#include "core/pipeline/parameters.h"
#include "core/volume/erase_mask.h"

namespace sonoskin {

// RecipeInput: what a recipe holds beside the parameters: of one scan alone.
//   key     the scan's fingerprint in hexadecimal digits; empty: the recipe is nobody's
//   erased  what was erased of it; no counts: nothing
struct RecipeInput {
  std::string key;
  RunLengths erased;
};

// writeRecipe: JSON with every parameter, the program's version, the input's fingerprint and what was erased of it; no
// patient data. From it and the input the same surface is made, bit by bit.
//   erased   not zero where nothing counts; may be null
//   errors   Error: what is erased has too many runs for a recipe
std::string writeRecipe(const Parameters& parameters, const Key& input = {},
                        const Volume<std::uint8_t>* erased = nullptr);

// readRecipe: sets the parameters that the recipe names and leaves the others.
//   errors   Error: not JSON, an unknown group or field, a value of the wrong kind or out of range, by name
RecipeInput readRecipe(const std::string& json, Parameters& parameters);

// kMostRecipeBytes: of a recipe's text.
inline constexpr std::uintmax_t kMostRecipeBytes = 16u << 20;

}  // namespace sonoskin
