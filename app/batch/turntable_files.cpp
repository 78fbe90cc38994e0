#include "app/batch/turntable_files.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/batch/film.h"
#include "core/base/log.h"
#include "core/io/file_formats.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;

constexpr double kTurnSeconds = 6, kLeastRate = 5, kMostRate = 30;
constexpr std::size_t kPackedAtOnce = 2;  // pictures: each takes some megabytes until it is written

fs::path folderOf(const fs::path& name) {
  requireFormat(FileKind::picture, name);
  return name.has_parent_path() ? name.parent_path() : fs::path(".");
}

}  // namespace

TurntableFiles::TurntableFiles(const fs::path& name, int views)
    : stem_(name.stem().string()), views_(views), folder_(folderOf(name)) {}

std::string TurntableFiles::taken(const fs::path& name) {
  for (const char* ending : {"_001.png", ".mp4"}) {
    const std::string file = name.stem().string() + ending;
    if (std::error_code error; fs::exists(folderOf(name) / file, error)) return file;
  }
  return {};
}

void TurntableFiles::write(int view, Image picture) {
  names_.push_back(fmt::format("{}_{:03}.png", stem_, view + 1));
  pictures_.push_back(folder_.file(names_.back()));
  writer_.write(pictures_.back(), std::move(picture));
  if (pictures_.size() % kPackedAtOnce == 0) writer_.finish();
}

void TurntableFiles::finish(const Progress& progress) {
  writer_.finish();
  const std::string film = stem_ + ".mp4";
  if (makeFilm(pictures_, std::clamp(views_ / kTurnSeconds, kLeastRate, kMostRate), folder_.file(film),
               progress))
    names_.push_back(film);
  else
    log(LogLevel::info, "No film was made of the pictures: that needs the program ffmpeg.");
  folder_.commit();
}

}  // namespace sonoskin
