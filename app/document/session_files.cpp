// The session's files: opening and saving, in the background.
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/document/input.h"
#include "app/document/opening.h"
#include "app/document/points_file.h"
#include "app/document/session.h"
#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "core/io/file_formats.h"
#include "core/io/mesh_writer.h"
#include "core/io/volume_reader.h"
#include "core/io/volume_writer.h"
#include "core/mesh/print/print_solid.h"
#include "core/pipeline/phantom_landmarks.h"
#include "core/pipeline/recipe.h"

namespace sonoskin {
namespace fs = std::filesystem;

// ---- opening

void Session::open(const std::string& label, Opened opened,
                   std::function<void(Opened&, const Progress&)> make) {
  const auto made = std::make_shared<Opened>(std::move(opened));
  opener_.replace({label, [made, make = std::move(make)](const Progress& progress) { make(*made, progress); },
                   [this, made] { adopt(std::move(*made)); }});
}

// A spacing that was given before any volume was is for the first one; what was typed for one volume is not for the next,
// nor is the time step.
void Session::openFile(const fs::path& path) {
  ScanOptions options = document_.parameters.scan;
  if (hasScan()) {
    options.spacing = ScanOptions().spacing;
    options.volume = ScanOptions().volume;
    options.time = ScanOptions().time;
    options.mirror = ScanOptions().mirror;
  }
  openFile(path, options);
}

void Session::openVolume(const VolumeChoice& choice, int volume) {
  ScanOptions options = choice.options;
  options.volume = volume;
  openFile(choice.path, options);
}

// Of several volumes a person chooses one, and then it is opened.
void Session::openFile(const fs::path& path, const ScanOptions& options) {
  const auto opened = std::make_shared<Opened>();
  const auto choice = std::make_shared<VolumeChoice>(VolumeChoice{path, options, {}});
  opened->name = path.filename().string();
  opened->source = path;
  opened->raw = document_.parameters.raw;
  const auto read = [opened, choice, path, options](const Progress& progress) {
    if (options.volume == 0)
      choice->volumes = listVolumes(path, readOptions(options, opened->raw), progress.cancelOnly());
    if (choice->volumes.size() > 1) return;
    readVolumeTo(*opened, options, progress);
  };
  opener_.replace({"Opening " + opened->name, read, [this, opened, choice] {
                     if (opened->scan.volume)
                       adopt(std::move(*opened));
                     else
                       choice_ = std::move(*choice);
                   }});
}

std::optional<VolumeChoice> Session::takeChoice() { return std::exchange(choice_, {}); }

void Session::openPhantom() {
  Opened opened{{}, "Phantom", phantomLandmarks(document_.parameters.phantom)};
  opened.phantom = document_.parameters.phantom;
  open("Simulating the phantom", std::move(opened),
       [options = document_.parameters.scan](Opened& made, const Progress& progress) {
         simulateTo(made, options, progress);
       });
}

// The spacing of a scan whose file gives none is a parameter like others; another one makes it another scan.
void Session::respace() {
  const std::array<double, 3>& spacing = document_.parameters.scan.spacing;
  if (!hasScan() || document_.givesSpacing || isSpaced(frame_.scan, spacing)) return;
  Opened opened{frame_.scan, document_.name};
  opened.givesSpacing = opened.isAnother = false;
  opened.reading = document_.reading;
  opened.raw = document_.raw;
  opened.source = document_.source;
  open("Setting the spacing", std::move(opened),
       [spacing](Opened& changed, const Progress&) { setSpacing(changed.scan, spacing); });
}

// Read twice: what is wrong with it is found aside, and what was moved meanwhile stays where the recipe does not name it.
void Session::loadRecipe(const fs::path& path) {
  const auto text = std::make_shared<std::string>();
  opener_.append({"Opening " + path.filename().string(),
                  [text, path, parameters = document_.parameters](const Progress&) mutable {
                    *text = readText(path, kMostRecipeBytes);
                    readRecipe(*text, parameters);
                  },
                  [this, text] { takeRecipe(*text); }});
}

// What a recipe erases is erased of its own scan alone.
void Session::takeRecipe(const std::string& text) {
  Parameters read = document_.parameters;
  const RecipeInput input = readRecipe(text, read);
  const auto erased = erasedIn(input, frame_.scan);
  change([&](Document& document) {
    if (erased) document.erased.become(*erased);
    document.change(read);
  });
  commitEdit();
}

void Session::loadErased(const fs::path& path) {
  require(hasScan(), "There is no volume to erase from; open it first.");
  const auto read = std::make_shared<Scan>(frame_.scan);
  opener_.replace({"Opening " + path.filename().string(),
                   [read, path, raw = document_.raw](const Progress& progress) {
                     setErased(*read, readMarks(path, raw, progress));
                   },
                   [this, read] {
                     change([&](Document& document) { document.erased.become(*read->erased); });
                     commitEdit();
                   }});
}

void Session::saveErased(const fs::path& path) {
  require(document_.erased.voxels() > 0, "Nothing is erased that could be saved; erase something first.");
  saveAlone(
      path,
      [path, mask = document_.erased.snapshot(), beam = frame_.scan.beam](const Progress& progress) {
        writeVolume(path, *mask, beam, progress);
      },
      [this, key = document_.erased.key()] { saved_.erased = key; });
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

void Session::save(const fs::path& path, const std::string& recipe,
                   std::function<void(const Progress&)> write, std::function<void()> saved) {
  saveAlone(
      path,
      [path, recipe, write = std::move(write)](const Progress& progress) {
        write(progress);
        const fs::path beside = fs::path(path).replace_extension(".recipe.json");
        if (std::error_code code; fs::exists(beside, code) && !isRecipe(beside))
          throw Error(
              fmt::format(
                  "{} is saved, but its recipe is not, for {} is something else; choose another name.",
                  path.filename().string(), beside.filename().string()),
              Error::Kind::system);
        writeBytes(beside, recipe.data(), recipe.size());
      },
      std::move(saved));
}

// A volume's own name may be a patient's.
std::string Session::proposedName(const std::string& ending) const { return "surface" + ending; }

std::string Session::recipeOfMesh(const Parameters& parameters) const {
  return writeRecipe(parameters, frame_.scan.key, frame_.made.erased.get());
}

void Session::warnOfMesh() {
  if (!meshIsCurrent())
    log(LogLevel::warning,
        "The surface that is saved is older than the parameters; the recipe beside it has its own.");
  if (!meshIsFinal())
    log(LogLevel::warning,
        "The surface that is saved was made with short cuts while the parameters moved; reconstruct it, and "
        "save "
        "it again, for one that its recipe repeats.");
}

void Session::saveMesh(const fs::path& path, const MeshPlacement& placement) {
  require(frame_.results.mesh != nullptr, "There is no surface to save yet; reconstruct it first.");
  warnOfMesh();
  save(
      path, recipeOfMesh(frame_.made.parameters),
      [path, placement, mesh = frame_.results.mesh](const Progress& progress) {
        writeMesh(path, *mesh, MeshFileOptions{{}, placement}, progress);
      },
      savedMesh(frame_.made.parameters));
}

void Session::savePrint(const fs::path& path) {
  require(frame_.results.mesh != nullptr, "There is no surface to print yet; reconstruct it first.");
  requireFormat(FileKind::printedMesh, path);
  ++longJobs_;
  warnOfMesh();
  Parameters parameters = frame_.made.parameters;
  parameters.print = document_.parameters.print;
  PrintOptions& options = parameters.print;
  if (options.form == PrintForm::none) options.form = PrintForm::shell;
  save(path, recipeOfMesh(parameters), [path, options, mesh = frame_.results.mesh](const Progress& progress) {
    writeMesh(path, makePrintSolid(*mesh, options, progress.part(0, 0.9)), progress.part(0.9, 1));
  });
}

// What is shown of a surface: itself as it was made, in the present light.
Parameters Session::shownParameters() const {
  Parameters parameters = frame_.made.parameters;
  parameters.skin = document_.parameters.skin;
  parameters.light = document_.parameters.light;
  parameters.landmarks = document_.parameters.landmarks;
  return parameters;
}

void Session::saveSkin(const fs::path& path, std::function<TexturedMesh()> make) {
  warnOfMesh();
  save(
      path, recipeOfMesh(shownParameters()),
      [path, make = std::move(make)](const Progress& progress) {
        writeTexturedMesh(path, make(), progress.part(0.5, 1));
      },
      savedMesh(shownParameters()));
}

void Session::savePicture(const fs::path& path, std::function<void(const Progress&)> write, bool showsMesh) {
  const std::string recipe = showsMesh ? recipeOfMesh(shownParameters()) : recipeNow();
  save(path, recipe, std::move(write));
}

void Session::saveScan(const fs::path& path) {
  require(hasScan(), "There is no scan to save; open one.");
  Scan scan = frame_.scan;
  scan.erased.reset();
  saveAlone(path, [path, scan](const Progress& progress) { writeScan(path, scan, progress); });
}

void Session::saveClassified(const fs::path& path) {
  require(frame_.results.classified != nullptr, "Nothing is classified yet; wait until it is.");
  saveAlone(path, [path, classified = frame_.results.classified, beam = frame_.scan.beam](
                      const Progress& progress) { writeVolume(path, *classified, beam, progress); });
}

void Session::saveThinned(const fs::path& path) {
  require(frame_.results.thinned != nullptr, "Nothing is thinned yet; wait until it is.");
  saveAlone(path, [path, thinned = frame_.results.thinned, beam = frame_.scan.beam](
                      const Progress& progress) { writeVolume(path, *thinned, beam, progress); });
}

void Session::savePoints(const fs::path& path) {
  require(frame_.results.points != nullptr, "There are no points yet; wait until they are found.");
  saveAlone(path, [path, points = frame_.results.points](const Progress&) { writePoints(path, *points); });
}

std::string Session::recipeNow() {
  return writeRecipe(recipeParameters(document_), frame_.scan.key, document_.erased.snapshot().get());
}

void Session::saveRecipe(const fs::path& path) {
  saveAlone(
      path, [path, recipe = recipeNow()](const Progress&) { writeBytes(path, recipe.data(), recipe.size()); },
      [this, now = presentState()] {
        saved_.content = now.content;
        saved_.erased = now.erased;
      });
}

}  // namespace sonoskin
