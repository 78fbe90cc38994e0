#pragma once

#include <string>
#include <vector>

#include "app/widgets/message_log.h"

namespace sonoskin::ui {

// Toasts: short messages. All leave by themselves, notes first, then warnings, then failures; a click opens the log, which keeps
// them, and whose button counts the warnings and failures that nobody has looked at.
struct Toasts {
  struct Toast {
    std::string text;
    bool failure = false, warning = false;
    double until = 0;  // ImGui's time; 0: not shown yet
  };
  std::vector<Toast> list;
  MessageLog log;

  void add(const std::string& text, bool failure);
  void warn(const std::string& text);

 private:
  void show(Toast toast);
};

// ToastPlace: where they are: above one another, from `bottom` up, so wide.
struct ToastPlace {
  float left, bottom, width;
};

// drawToasts: seconds until the next one must go, negative where none will.
double drawToasts(Toasts& toasts, ToastPlace place);

}  // namespace sonoskin::ui
