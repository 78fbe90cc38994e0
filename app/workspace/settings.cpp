#include "app/workspace/settings.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/file_bytes.h"
#include "core/io/private_file.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kMostRecent = 8;

// The value of a name; the first one where nothing has it.
template <class E>
E named(const std::string& name) {
  const auto names = enumNames(E{});
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? E{} : E(found - names.begin());
}

// Takes a value where the file has one of its type; else the setting stays as it is.
template <class T>
void take(const json& root, const char* key, T& value) {
  const auto found = root.find(key);
  if (found == root.end()) return;
  if constexpr (std::is_same_v<T, bool>) {
    if (found->is_boolean()) value = found->get<bool>();
  } else if constexpr (std::is_enum_v<T>) {
    if (found->is_string()) value = named<T>(found->get<std::string>());
  } else {
    if (found->is_string()) value = found->get<std::string>();
  }
}

// As double: the library casts a number that no int holds, which C++ leaves undefined.
double numberIn(const json& root, const char* key, double standard) {
  const auto found = root.find(key);
  return found != root.end() && found->is_number() ? found->get<double>() : standard;
}

double scaleIn(const json& root) {
  const double scale = numberIn(root, "scale", 0);
  return scale > 0 ? std::clamp(scale, kLeastScale, kMostScale) : 0;
}

std::vector<fs::path> recentIn(const json& root) {
  std::vector<fs::path> files;
  const auto found = root.find("recent");
  if (found == root.end() || !found->is_array()) return files;
  for (const json& file : *found)
    if (file.is_string()) files.emplace_back(file.get<std::string>());
  return files;
}

constexpr std::array<const char*, 3> kPlaneNames{"sagittal", "coronal", "axial"};

LayoutState readLayout(const json& root) {
  LayoutState layout;
  take(root, "layout", layout.layout);
  const auto share = [&](const char* name, float standard) {
    return float(std::clamp(numberIn(root, name, standard), double(kLeastShare), double(kMostShare)));
  };
  layout.across = share("dividerAcross", layout.across);
  layout.down = share("dividerDown", layout.down);
  std::string compared;
  take(root, "comparedPlane", compared);
  for (const Plane plane : kPlanes)
    if (compared == kPlaneNames[std::size_t(plane)]) layout.compared = plane;
  return layout;
}

// What is no JSON is kept beside, for it may be mended by hand.
void setAside(const fs::path& file) {
  std::error_code code;
  fs::rename(file, fs::path(file) += ".damaged", code);
  log(LogLevel::warning,
      "The settings are damaged and were set aside as settings.json.damaged; no files are remembered until "
      "File > Open recent > Remember files is chosen.");
}

}  // namespace

void Settings::noteOpened(const fs::path& file) {
  if (!remembersFiles) return;
  std::error_code error;
  const fs::path full = fs::absolute(file, error);
  recent.erase(std::remove(recent.begin(), recent.end(), full), recent.end());
  recent.insert(recent.begin(), full);
  if (recent.size() > kMostRecent) recent.resize(kMostRecent);
}

fs::path settingsFile() {
  if (const char* config = std::getenv("XDG_CONFIG_HOME"); config && *config) {
    return fs::path(config) / "sonoskin/settings.json";
  }
  if (const char* home = std::getenv("HOME"); home && *home)
    return fs::path(home) / ".config/sonoskin/settings.json";
  return {};
}

Settings readSettings(const fs::path& file) {
  Settings settings;
  json root;
  try {
    root = json::parse(readText(file), nullptr, false);
  } catch (const Error&) {
    return settings;
  }
  if (!root.is_object()) {
    setAside(file);
    settings.remembersFiles = false;  // whoever wanted that would not be asked again
    return settings;
  }
  std::string folder;
  take(root, "folder", folder);
  settings.folder = folder;
  settings.recent = recentIn(root);
  take(root, "remembersFiles", settings.remembersFiles);
  take(root, "tourOffered", settings.tourOffered);
  settings.width = int(std::clamp(numberIn(root, "width", settings.width), 800.0, 8192.0));
  settings.height = int(std::clamp(numberIn(root, "height", settings.height), 600.0, 8192.0));
  take(root, "skinQuality", settings.skinQuality);
  take(root, "appearance", settings.appearance);
  take(root, "language", settings.language);
  settings.scale = scaleIn(root);
  settings.layout = readLayout(root);
  return settings;
}

void writeSettings(const fs::path& file, const Settings& settings) {
  if (file.empty()) return;
  json recent = json::array();
  for (const fs::path& f : settings.recent) recent.push_back(f.string());
  const json root{{"folder", settings.folder.string()},
                  {"recent", recent},
                  {"remembersFiles", settings.remembersFiles},
                  {"tourOffered", settings.tourOffered},
                  {"width", settings.width},
                  {"height", settings.height},
                  {"skinQuality", enumNames(SkinQualityChoice{})[std::size_t(settings.skinQuality)]},
                  {"appearance", enumNames(Appearance{})[std::size_t(settings.appearance)]},
                  {"language", enumNames(LanguageChoice{})[std::size_t(settings.language)]},
                  {"scale", settings.scale},
                  {"layout", enumNames(Layout{})[std::size_t(settings.layout.layout)]},
                  {"dividerAcross", settings.layout.across},
                  {"dividerDown", settings.layout.down},
                  {"comparedPlane", kPlaneNames[std::size_t(settings.layout.compared)]}};
  const std::string text = root.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
  try {
    writePrivately(file, text);
  } catch (const Error&) {
  }
}

}  // namespace sonoskin
