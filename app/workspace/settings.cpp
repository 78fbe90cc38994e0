#include "app/workspace/settings.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
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

double scaleIn(const json& root) {
  const double scale = root.value("scale", 0.0);
  return scale > 0 ? std::clamp(scale, kLeastScale, kMostScale) : 0;
}

constexpr std::array<const char*, 3> kPlaneNames{"sagittal", "coronal", "axial"};

LayoutState readLayout(const json& root) {
  LayoutState layout;
  layout.layout = named<Layout>(root.value("layout", std::string()));
  const auto share = [&](const char* name, float standard) {
    return float(std::clamp(root.value(name, double(standard)), double(kLeastShare), double(kMostShare)));
  };
  layout.across = share("dividerAcross", layout.across);
  layout.down = share("dividerDown", layout.down);
  const std::string compared = root.value("comparedPlane", std::string());
  for (const Plane plane : kPlanes)
    if (compared == kPlaneNames[std::size_t(plane)]) layout.compared = plane;
  return layout;
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
  }
  if (!root.is_object()) return settings;
  try {
    settings.folder = root.value("folder", std::string());
    for (const json& recent : root.value("recent", json::array()))
      settings.recent.emplace_back(recent.get<std::string>());
    settings.remembersFiles = root.value("remembersFiles", true);
    settings.tourOffered = root.value("tourOffered", false);
    // As double: the library casts a number that no int holds, which C++ leaves undefined.
    settings.width = int(std::clamp(root.value("width", double(settings.width)), 800.0, 8192.0));
    settings.height = int(std::clamp(root.value("height", double(settings.height)), 600.0, 8192.0));
    settings.skinQuality = named<SkinQualityChoice>(root.value("skinQuality", std::string()));
    settings.appearance = named<Appearance>(root.value("appearance", std::string()));
    settings.language = named<LanguageChoice>(root.value("language", std::string()));
    settings.scale = scaleIn(root);
    settings.layout = readLayout(root);
  } catch (const json::exception&) {
    return {};
  }
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
