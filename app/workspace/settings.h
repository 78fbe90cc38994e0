#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "app/texts/language_choice.h"
#include "app/widgets/appearance.h"
#include "app/workspace/layout_state.h"

namespace sonoskin {

// SkinQualityChoice: how fine skin is shown in the window; automatic: as fine as the machine draws it fluently.
enum class SkinQualityChoice { automatic, full, light };
constexpr std::array<const char*, 3> enumNames(SkinQualityChoice) { return {"automatic", "full", "light"}; }

inline constexpr double kLeastScale = 1, kMostScale = 3;

// Settings: what the window remembers from one start to the next.
struct Settings {
  std::filesystem::path folder;               // where files were last opened or saved
  std::vector<std::filesystem::path> recent;  // volumes, the latest first
  bool remembersFiles = true;                 // whether `recent` is filled and kept
  bool tourOffered = false;                   // whether the tour was, at a first start
  int width = 1500, height = 940;             // of the window, at content scale 1
  SkinQualityChoice skinQuality = SkinQualityChoice::automatic;
  Appearance appearance = Appearance::dark;
  LanguageChoice language = LanguageChoice::system;
  double scale = 0;  // of texts and widgets, kLeastScale to kMostScale; 0: as the screen has it
  LayoutState layout;

  // noteOpened: puts a volume at the head of the recent ones.
  void noteOpened(const std::filesystem::path& file);
};

// settingsFile: $XDG_CONFIG_HOME or ~/.config, /sonoskin/settings.json; empty where there is no home.
std::filesystem::path settingsFile();

// readSettings: what the file holds, else defaults. What is no JSON is set aside (.damaged), and no files are remembered.
Settings readSettings(const std::filesystem::path& file);
// writeSettings: for this user's eyes alone (mode 600); makes the folder where needed. A failure is not worth a word:
// nothing is lost but comfort.
void writeSettings(const std::filesystem::path& file, const Settings& settings);

}  // namespace sonoskin
