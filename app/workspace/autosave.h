#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/document/worker.h"
#include "app/workspace/autosave_slot.h"
#include "core/base/hash.h"
#include "core/base/timer.h"

namespace sonoskin {

struct Workspace;

// Autosave: keeps what is open in a file of the state folder, written in the background: when another document opens, before
// work that takes long, and a while after anything has changed. Where the program ends as it should, the file goes; else the
// next start finds it.
class Autosave {
 public:
  // Without a folder nothing is kept.
  explicit Autosave(std::filesystem::path folder) : folder_(std::move(folder)) {}
  ~Autosave();

  // look: once a frame; writes where it is time.
  //   errors  Error (system): the folder cannot be written; once
  void look(Workspace& workspace);
  // goOn: with the file that another program left, once what it holds is open; else it is left again.
  //   output  that file
  const std::filesystem::path& goOn(AutosaveSlot slot);

  // file: that it writes, or will go on with; empty: none yet.
  std::filesystem::path file() const { return slot_ ? slot_->file() : std::filesystem::path(); }

  double seconds = 60;  // from a change to the file

 private:
  bool isDue(const Workspace& workspace);
  void write(Workspace& workspace);

  std::filesystem::path folder_;
  std::optional<AutosaveSlot> slot_, left_;
  Key kept_;                      // of what the file holds
  std::optional<Timer> changed_;  // since something else is open
  Timer looked_;
  std::uint64_t opened_ = 0, longJobs_ = 0;
  bool failed_ = false;  // there is no place for the file
  bool told_ = false;    // it was said that something could not be written
  Worker worker_;        // the last: it ends before the file goes
};

// readableLeft: what programs left that ended unexpectedly and can be read, the newest first. What cannot be read, being damaged or
// of a newer version, stays where it is, and a warning names it.
std::vector<AutosaveSlot> readableLeft(const std::filesystem::path& folder);

// leftText: a session file that was left, in a line for people: when it was written, and of what; empty where it cannot be
// read.
std::string leftText(const std::filesystem::path& file);

}  // namespace sonoskin
