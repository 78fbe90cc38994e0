#pragma once

#include <filesystem>
#include <vector>

namespace sonoskin {

// stateFolder: $XDG_STATE_HOME or ~/.local/state, /sonoskin; empty where there is no home.
std::filesystem::path stateFolder();

// AutosaveSlot: a session file in the state folder that belongs to one running program. A lock beside it says that the program
// lives, and goes with it however it ends. A slot that is destroyed takes both files away: the program ended as it should.
class AutosaveSlot {
 public:
  // In a folder, which is made where missing.
  //   errors  Error (system): it cannot be written
  explicit AutosaveSlot(const std::filesystem::path& folder);
  ~AutosaveSlot() { remove(); }
  AutosaveSlot(AutosaveSlot&& other) noexcept { swap(other); }
  AutosaveSlot& operator=(AutosaveSlot&& other) noexcept {
    swap(other);
    return *this;
  }

  // file: the session, which may not be there yet.
  const std::filesystem::path& file() const { return file_; }
  // leave: lets go of it, for a later start to find.
  void leave();

  // left: what programs left that ended unexpectedly, the newest first, each now of this program. What is older than a month,
  // or holds nothing, is taken away.
  static std::vector<AutosaveSlot> left(const std::filesystem::path& folder);

 private:
  AutosaveSlot(std::filesystem::path lock, int descriptor);
  void swap(AutosaveSlot& other) noexcept;
  void remove();

  std::filesystem::path lock_, file_;
  int descriptor_ = -1;
};

}  // namespace sonoskin
