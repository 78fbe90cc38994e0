// The session's files: opening and saving, in the background.
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/session.h"
#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "core/io/mesh_writer.h"
#include "core/io/volume_reader.h"
#include "core/io/volume_writer.h"
#include "core/mesh/print_solid.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/phantom_landmarks.h"
#include "core/pipeline/recipe.h"

namespace sonoskin {
namespace fs = std::filesystem;

// ---- opening

void Session::open(const std::string& label, Opened opened, std::function<Scan(const Progress&)> make) {
  const auto made = std::make_shared<Opened>(std::move(opened));
  opener_.replace({label,
                   [made, make = std::move(make)](const Progress& progress) { made->scan = make(progress); },
                   [this, made] { adopt(std::move(*made)); }});
}

void Session::openFile(const fs::path& path) {
  const std::string name = path.filename().string();
  open("Opening " + name, {{}, name}, [path](const Progress& progress) { return readScan(path, progress); });
}

void Session::openPhantom() {
  open("Simulating the phantom", {{}, "Phantom", phantomLandmarks(parameters_.phantom)},
       [options = parameters_.phantom](const Progress& progress) {
         return makePhantomScan(options, progress);
       });
}

void Session::setSpacing(const glm::dvec3& spacing) {
  open("Setting the spacing", {{}, name_}, [scan = scan_, spacing](const Progress&) {
    auto volume = std::make_shared<Volume<float>>(*scan.volume);
    volume->geometry.spacing = spacing;
    Scan changed = scan;
    changed.key = scanKey(*volume, scan.beam);
    changed.volume = std::move(volume);
    changed.spacingKnown = true;
    return changed;
  });
}

void Session::loadRecipe(const fs::path& path) {
  Parameters read = parameters_;
  readRecipe(readText(path), read);
  show(read);
  commitEdit();
}

void Session::loadErased(const fs::path& path) {
  require(hasScan(), "open the volume first, then what was erased of it");
  const auto read = std::make_shared<Scan>(scan_);
  opener_.replace({"Opening " + path.filename().string(),
                   [read, path](const Progress& progress) { setErased(*read, readMarks(path, progress)); },
                   [this, read] {
                     erased_.become(*read->erased);
                     show(parameters_);
                     commitEdit();
                   }});
}

void Session::saveErased(const fs::path& path) {
  require(erased_.voxels() > 0, "nothing is erased, so there is nothing to save");
  saveAlone(
      path,
      [path, mask = erased_.snapshot(), beam = scan_.beam](const Progress& progress) {
        writeVolume(path, *mask, beam, progress);
      },
      [this, key = erased_.key()] { savedErased_ = key; });
}

// ---- saving

namespace {

// Whether a file is a recipe, which a new one may replace.
bool isRecipe(const fs::path& file) try {
  const nlohmann::json root = nlohmann::json::parse(readText(file), nullptr, false);
  return root.is_object() && root.contains("sonoskin");
} catch (const Error&) {
  return false;
}

}  // namespace

void Session::saveAlone(const fs::path& path, std::function<void(const Progress&)> write,
                        std::function<void()> saved) {
  saver_.append(
      {"Saving " + path.filename().string(), std::move(write), [this, path, saved = std::move(saved)] {
         if (saved) saved();
         report(Message::Kind::note, "Saved " + path.string());
       }});
}

bool Session::hasUnsavedWork() const {
  const bool hasSurface = results_.mesh && reconstructions_ > 0;
  return (hasSurface && !(meshKey_ == savedMesh_)) ||
         (erased_.voxels() > 0 && !(erased_.key() == savedErased_));
}

void Session::save(const fs::path& path, std::function<void(const Progress&)> write,
                   std::function<void()> saved) {
  const std::string recipe = writeRecipe(parameters_, scan_.key);
  saveAlone(
      path,
      [path, recipe, write = std::move(write)](const Progress& progress) {
        write(progress);
        const fs::path beside = fs::path(path).replace_extension(".recipe.json");
        if (std::error_code code; fs::exists(beside, code) && !isRecipe(beside))
          throw Error(fmt::format("{} is saved, but its recipe is not: {} is something else.",
                                  path.filename().string(), beside.filename().string()),
                      Error::Kind::system);
        writeBytes(beside, recipe.data(), recipe.size());
      },
      std::move(saved));
}

// A volume's own name may be a patient's.
std::string Session::proposedName(const std::string& ending) const { return "surface" + ending; }

void Session::saveMesh(const fs::path& path) {
  require(results_.mesh != nullptr, "there is no surface to save yet; reconstruct it first");
  save(
      path, [path, mesh = results_.mesh](const Progress& progress) { writeMesh(path, *mesh, progress); },
      [this, key = meshKey_] { savedMesh_ = key; });
}

void Session::savePrint(const fs::path& path) {
  require(results_.mesh != nullptr, "there is no surface to print yet; reconstruct it first");
  PrintOptions options = parameters_.print;
  if (options.form == PrintForm::none) options.form = PrintForm::shell;
  save(path, [path, options, mesh = results_.mesh](const Progress& progress) {
    writeMesh(path, makePrintSolid(*mesh, options, progress.part(0, 0.9)), progress.part(0.9, 1));
  });
}

void Session::saveSkin(const fs::path& path, TexturedMesh surface) {
  const auto baked = std::make_shared<TexturedMesh>(std::move(surface));
  save(path, [path, baked](const Progress& progress) { writeTexturedMesh(path, *baked, progress); });
}

void Session::savePicture(const fs::path& path, Image image) {
  const auto picture = std::make_shared<Image>(std::move(image));
  save(path, [path, picture](const Progress&) { writePng(path, *picture); });
}

void Session::saveRecipe(const fs::path& path) {
  saveAlone(path, [path, recipe = writeRecipe(parameters_, scan_.key)](const Progress&) {
    writeBytes(path, recipe.data(), recipe.size());
  });
}

}  // namespace sonoskin
