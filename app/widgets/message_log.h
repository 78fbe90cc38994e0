#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace sonoskin::ui {

// MessageLog: what was said in the window, the oldest first, for those who were not looking.
struct MessageLog {
  enum class Kind { note, warning, failure };
  struct Entry {
    std::string time;  // of the day, local: "14:03:59"
    Kind kind = Kind::note;
    std::string text;  // one sentence
  };
  std::vector<Entry> entries;                    // at most kMost
  bool shown = false;                            // the panel is open
  std::array<bool, 3> levels{true, true, true};  // which kinds are shown
  std::vector<std::filesystem::path> files;      // see hide()
  std::size_t unseen = 0;                        // warnings and failures since it was last open

  static constexpr std::size_t kMost = 1000;

  // add: at the present time. What is said again at once only gets the new time.
  void add(Kind kind, const std::string& text);
  void open();
  bool shows(const Entry& entry) const { return levels[std::size_t(entry.kind)]; }
  std::size_t count(Kind kind) const;
  void clear();
  // hide: a file that a person has chosen, whose name is not to leave with the text.
  void hide(const std::filesystem::path& file) { files.push_back(file); }
  // text: what is shown, a line each, without names of files and folders; for others to read.
  std::string text() const;
};

}  // namespace sonoskin::ui
