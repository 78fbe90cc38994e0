#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/pipeline/recipe.h"

namespace sonoskin {

// SessionFile: what a session file (.sonoskin, JSON) holds: what brings a document, and the window on it, back. No patient
// data; but where the volume lies on this machine, as the list of recent files has it.
//   volume      an absolute path; kPhantomInput: the scan is simulated; empty: not told, and the person is asked
//   recipe      as writeRecipe() makes it, with the volume's fingerprint
//   hasSurface  whether there was a surface; it is made again
//   surface     the recipe that it was made by, where it was older than the parameters; else empty
//   follows     whether it follows the parameters
//   views       a JSON object, of the window's own; a document does not look into it
struct SessionFile {
  std::filesystem::path volume;
  std::string recipe;
  bool hasSurface = false, follows = true;
  std::string surface{};
  std::string views = "{}";
};

// kMostSessionBytes: of a session's text.
inline constexpr std::uintmax_t kMostSessionBytes = 2 * kMostRecipeBytes + (1u << 20);

// writeSessionFile: the text of a file.
//   session  recipe and views are JSON objects
std::string writeSessionFile(const SessionFile& session);

// readSessionFile: the same from a text. Its recipe is read by readRecipe().
//   errors  Error: not JSON, or no session
SessionFile readSessionFile(const std::string& text);

// recipeIn: the recipe of a session; any other text as it is.
//   errors  Error: a session of a newer Sonoskin, or without a recipe
std::string recipeIn(const std::string& text);

}  // namespace sonoskin
