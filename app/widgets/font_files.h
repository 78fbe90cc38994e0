#pragma once

#include <string>

namespace sonoskin {

enum class FontStyle { regular, semibold };

// FontFiles: paths; empty where nothing fits.
struct FontFiles {
  std::string text;      // what most glyphs come from
  std::string fallback;  // for the glyphs that `text` lacks
};

// findFontFiles: Inter and DejaVu Sans among the fonts installed on this machine, by file name.
FontFiles findFontFiles(FontStyle style);

}  // namespace sonoskin
