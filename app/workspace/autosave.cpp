#include "app/workspace/autosave.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <ctime>
#include <utility>

#include "app/document/input.h"
#include "app/texts/texts.h"
#include "app/workspace/view_file.h"
#include "app/workspace/workspace.h"
#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/file_bytes.h"
#include "core/io/file_formats.h"
#include "core/io/private_file.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr double kLookSeconds = 1;  // between two looks at what has changed

Key keyOf(const Workspace& w) {
  return Hasher("open").add(w.session.workKey()).add(writeViews(w.view)).key();
}

// A simulated scan that nobody has touched is no loss.
bool isWorthIt(const Workspace& w) {
  return w.session.hasScan() && (w.isModified() || !w.session.source().empty());
}

}  // namespace

bool Autosave::isDue(const Workspace& w) {
  const bool begins = std::exchange(opened_, w.session.opened()) != w.session.opened() ||
                      std::exchange(longJobs_, w.session.longJobs()) != w.session.longJobs();
  if (!begins && looked_.seconds() < kLookSeconds) return false;
  looked_ = {};
  const Key now = keyOf(w);
  if (now == kept_) {
    changed_.reset();
    return false;
  }
  if (!changed_) changed_.emplace();
  if (!begins && changed_->seconds() < seconds) return false;
  kept_ = now;
  changed_.reset();
  return true;
}

void Autosave::look(Workspace& w) {
  for (const std::string& sentence : worker_.poll())
    if (!std::exchange(told_, true)) log(LogLevel::warning, sentence);
  if (left_ && w.restored) {
    slot_.emplace(std::move(*left_));
    left_.reset();
  }
  if (folder_.empty() || failed_ || !w.session.hasScan() || !isDue(w)) return;
  if (isWorthIt(w))
    write(w);
  else
    slot_.reset();
}

const fs::path& Autosave::goOn(AutosaveSlot slot) { return left_.emplace(std::move(slot)).file(); }

Autosave::~Autosave() {
  if (left_) left_->leave();
}

// Where a person does not want files to be remembered, a crash does not remember them either.
void Autosave::write(Workspace& w) {
  failed_ = true;  // until it is done
  if (!slot_) slot_.emplace(folder_);
  failed_ = false;
  const bool names = w.settings.remembersFiles;
  worker_.append(
      {"",
       [file = slot_->file(), names, make = w.session.capture(writeViews(w.view))](const Progress&) {
         SessionFile session = make();
         if (!names && session.volume != kPhantomInput) session.volume.clear();
         writePrivately(file, writeSessionFile(session));
       },
       {}});
}

std::vector<AutosaveSlot> readableLeft(const fs::path& folder) {
  std::vector<AutosaveSlot> readable;
  for (AutosaveSlot& slot : AutosaveSlot::left(folder)) {
    if (!leftText(slot.file()).empty()) {
      readable.push_back(std::move(slot));
      continue;
    }
    slot.leave();
    log(LogLevel::warning,
        fmt::format("What was open when Sonoskin ended unexpectedly cannot be read; it stays in {}.",
                    slot.file().string()));
  }
  return readable;
}

std::string leftText(const fs::path& file) try {
  const SessionFile session = readSessionFile(readText(file, kMostSessionBytes));
  struct stat facts {};
  if (::stat(file.c_str(), &facts) != 0) return {};
  std::tm when{};
  ::localtime_r(&facts.st_mtime, &when);
  const auto format = formatNamed(FileKind::readVolume, session.volume);
  const std::string kind = session.volume == kPhantomInput ? std::string(tr("simulated scan"))
                           : format                        ? std::string(formatName(*format))
                                                           : std::string(tr("volume"));
  return fmt::format("{:%Y-%m-%d %H:%M}, {}", when, kind);
} catch (const Error&) {
  return {};
}

}  // namespace sonoskin
