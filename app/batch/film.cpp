#include "app/batch/film.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <thread>

#include "core/base/error.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr double kLeastSeconds = 3;

// What ffmpeg's "concat" reads. The last picture is named again, or its duration would not count.
void writeList(const fs::path& list, const std::vector<fs::path>& pictures, double perSecond) {
  const double once = double(pictures.size()) / perSecond;
  const int rounds = std::max(1, int(std::ceil(kLeastSeconds / once)));
  std::ofstream file(list);
  for (int round = 0; round < rounds; ++round)
    for (const fs::path& picture : pictures)
      file << fmt::format("file '{}'\nduration {:.6f}\n", picture.filename().string(), 1 / perSecond);
  file << fmt::format("file '{}'\n", pictures.back().filename().string());
  file.close();
  if (!file)
    throw Error("The film's pictures could not be listed; the disk may be full.", Error::Kind::system);
}

// Starts a program that is looked for in PATH, with neither input nor output; its process, or 0.
pid_t start(std::vector<std::string> arguments) {
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (int stream = 0; stream <= 2; ++stream)
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  pid_t process = 0;
  const int failed = posix_spawnp(&process, words.front(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return failed ? 0 : process;
}

// Whether it ended well.
bool waitFor(pid_t process, const Progress& progress) {
  int status = 0;
  while (::waitpid(process, &status, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (!progress.cancelled()) continue;
    ::kill(process, SIGKILL);
    ::waitpid(process, &status, 0);
    throw Cancelled();
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

bool makeFilm(const std::vector<fs::path>& pictures, double perSecond, const fs::path& film,
              const Progress& progress) {
  const fs::path list = pictures.front().parent_path() / "film.txt";
  std::error_code ignored;
  bool made = false;
  try {
    writeList(list, pictures, perSecond);
    // Most players want an even number of pixels and quarter the colour.
    const pid_t process =
        start({"ffmpeg", "-nostdin", "-y", "-f", "concat", "-i", list.string(), "-vf",
               "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-map_metadata", "-1", film.string()});
    made = process > 0 && waitFor(process, progress) && fs::exists(film, ignored);
  } catch (...) {
    fs::remove(list, ignored);
    fs::remove(film, ignored);
    throw;
  }
  fs::remove(list, ignored);
  if (!made) fs::remove(film, ignored);
  return made;
}

}  // namespace sonoskin
