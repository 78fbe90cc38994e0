// The session's own files: a document that is saved whole, and opened again.
#include <memory>
#include <utility>

#include "app/document/input.h"
#include "app/document/opening.h"
#include "app/document/session.h"
#include "core/base/error.h"
#include "core/base/log.h"
#include "core/base/shown_text.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

// Reopening: a session on its way from a file into the document.
struct Reopening {
  SavedSession saved;
  Opened opened{};
  std::string lost{};  // why its volume could not be opened; empty: it is there
};

// The volume where it was, or beside the session, where both were moved.
fs::path placeOf(const SavedSession& saved) {
  std::error_code code;
  const fs::path& volume = saved.file.volume;
  const fs::path beside = saved.path.parent_path() / volume.filename();
  return volume.empty() || fs::exists(volume, code) || !fs::exists(beside, code) ? volume : beside;
}

void readVolumeOf(Reopening& it, const ScanOptions& options, const Progress& progress) {
  std::error_code code;
  const fs::path place = placeOf(it.saved);
  if (place.empty() || !fs::exists(place, code)) {
    it.lost = place.empty() ? "The session does not tell where its volume is"
                            : "The session's volume is not there: " + shownText(place.filename().string());
    return;
  }
  it.opened.source = place;
  it.opened.name = place.filename().string();
  readVolumeTo(it.opened, options, progress);
}

// What a person made of one volume is nothing for another. A simulated one may have changed with the program, and there
// is no other to be found.
void compareKeys(Reopening& it, const RecipeInput& input) {
  if (input.key == it.opened.scan.key.hex()) return;
  if (it.opened.phantom) {
    log(LogLevel::warning,
        "This version simulates the phantom otherwise than the one that saved the session.");
  } else {
    it.lost = "The session was saved with another volume than " + shownText(it.opened.name);
  }
}

// A surface that was older than the parameters is made again from what it was made from.
void readOlder(Reopening& it) {
  if (it.saved.file.surface.empty()) return;
  OlderSurface older{it.opened.scan, {}};
  const RecipeInput input = readRecipe(it.saved.file.surface, older.parameters);
  if (auto erased = erasedIn(input, older.scan)) setErased(older.scan, std::move(*erased));
  it.saved.older = std::move(older);
}

void reopen(Reopening& it, const Progress& progress) {
  Parameters parameters;
  const RecipeInput input = readRecipe(it.saved.file.recipe, parameters);
  Opened& opened = it.opened;
  opened.raw = parameters.raw;
  opened.landmarks = parameters.landmarks;
  if (it.saved.file.volume == kPhantomInput) {
    opened.name = "Phantom";
    opened.phantom = parameters.phantom;
    simulateTo(opened, parameters.scan, progress);
  } else {
    readVolumeOf(it, parameters.scan, progress);
  }
  if (it.lost.empty()) compareKeys(it, input);
  if (!it.lost.empty()) return;
  readOlder(it);
  if (auto erased = erasedIn(input, opened.scan)) setErased(opened.scan, std::move(*erased));
  opened.parameters = parameters;
}

}  // namespace

void Session::openSession(const fs::path& path, bool recovers) {
  const auto it = std::make_shared<Reopening>();
  it->saved.path = path;
  it->saved.recovers = recovers;
  const auto read = [it, path](const Progress& progress) {
    it->saved.file = readSessionFile(readText(path, kMostSessionBytes));
    reopen(*it, progress);
  };
  const std::string label = recovers ? "Restoring the session" : "Opening " + path.filename().string();
  opener_.replace(
      {label, read, [this, it] { adopt(std::move(it->saved), std::move(it->opened), it->lost); }});
}

void Session::openSession(const LostVolume& lost, const fs::path& volume) {
  const auto it = std::make_shared<Reopening>();
  it->saved = lost.saved;
  it->saved.file.volume = fs::absolute(volume);
  opener_.replace({"Opening " + volume.filename().string(),
                   [it](const Progress& progress) { reopen(*it, progress); },
                   [this, it] { adopt(std::move(it->saved), std::move(it->opened), it->lost); }});
}

void Session::adopt(SavedSession saved, Opened opened, const std::string& lost) {
  if (!lost.empty()) {
    lost_ = LostVolume{std::move(saved), lost};
    return;
  }
  adopt(std::move(opened));
  follows_ = saved.file.follows;
  surfaceOwed_ = saved.file.hasSurface;
  older_ = saved.older;
  if (saved.recovers) saved_.content = {};  // nobody has saved it
  reopened_ = std::move(saved);
}

std::optional<LostVolume> Session::takeLostVolume() { return std::exchange(lost_, {}); }

std::optional<SavedSession> Session::takeReopened() { return std::exchange(reopened_, {}); }

// The text of a recipe with thousands of runs takes a while.
std::function<SessionFile()> Session::capture(const std::string& views) {
  require(hasScan(), "There is nothing to save as a session; open a volume.");
  SessionFile file;
  file.volume = document_.phantom ? fs::path(kPhantomInput) : fs::absolute(document_.source);
  file.hasSurface = frame_.results.mesh || surfaceOwed_;
  file.follows = follows_;
  file.views = views;
  std::optional<OlderSurface> older = older_;
  if (!surfaceOwed_ && frame_.results.mesh && !meshIsCurrent()) {
    older = OlderSurface{frame_.scan, frame_.made.parameters};
    older->scan.erased = frame_.made.erased;
  }
  return [file, parameters = recipeParameters(document_), key = frame_.scan.key,
          erased = document_.erased.snapshot(), older] {
    SessionFile whole = file;
    whole.recipe = writeRecipe(parameters, key, erased.get());
    if (older) whole.surface = writeRecipe(older->parameters, key, older->scan.erased.get());
    return whole;
  };
}

void Session::saveSession(const fs::path& path, const std::string& views, std::function<void()> saved) {
  saveAlone(
      path,
      [path, make = capture(views)](const Progress&) {
        const std::string text = writeSessionFile(make());
        writeBytes(path, text.data(), text.size());
      },
      [this, all = presentState(), saved = std::move(saved)] {
        saved_ = all;
        if (saved) saved();
      });
}

}  // namespace sonoskin
