#include "app/widgets/font_files.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace sonoskin {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> fontFolders() {
  std::vector<fs::path> folders{"/usr/share/fonts", "/usr/local/share/fonts"};
  if (const char* home = std::getenv("HOME")) folders.push_back(fs::path(home) / ".local/share/fonts");
  return folders;
}

// Every font file of the machine. Folders that cannot be read are left out.
std::vector<fs::path> listFonts() {
  std::vector<fs::path> files;
  for (const fs::path& folder : fontFolders()) {
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
    for (; !error && entry != end; entry.increment(error)) {
      const fs::path extension = entry->path().extension();
      if (extension == ".otf" || extension == ".ttf") files.push_back(entry->path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

// The first of `names` that is installed.
std::string firstOf(std::initializer_list<std::string_view> names) {
  static const std::vector<fs::path> fonts = listFonts();
  for (std::string_view name : names) {
    const auto found =
        std::find_if(fonts.begin(), fonts.end(), [&](const fs::path& f) { return f.filename() == name; });
    if (found != fonts.end()) return found->string();
  }
  return {};
}

}  // namespace

FontFiles findFontFiles(FontStyle style) {
  const bool bold = style == FontStyle::semibold;
  const std::string inter = bold ? firstOf({"Inter-SemiBold.otf", "Inter-SemiBold.ttf", "Inter-Bold.otf"})
                                 : firstOf({"Inter-Regular.otf", "Inter-Regular.ttf"});
  const std::string dejaVu =
      bold ? firstOf({"DejaVuSans-Bold.ttf", "DejaVuSans.ttf"}) : firstOf({"DejaVuSans.ttf"});
  return inter.empty() ? FontFiles{dejaVu, ""} : FontFiles{inter, dejaVu};
}

}  // namespace sonoskin
