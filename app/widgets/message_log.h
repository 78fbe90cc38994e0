#pragma once

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
  std::vector<Entry> entries;  // at most kMost
  bool shown = false;          // the panel is open
  std::size_t unseen = 0;      // warnings and failures since it was last open

  static constexpr std::size_t kMost = 1000;

  // add: at the present time. What is said again at once only gets the new time.
  void add(Kind kind, const std::string& text);
  void open();
  // text: all of it, a line each, for the clipboard.
  std::string text() const;
};

}  // namespace sonoskin::ui
