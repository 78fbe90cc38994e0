#pragma once

#include <string>
#include <vector>

#include "app/widgets/message_log.h"

namespace sonoskin::ui {

// Toasts: short messages at the lower right. Notes and, later, warnings leave by themselves; failures stay until they are
// clicked. A click opens the log, which keeps them all.
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

// drawToasts: draws them above `bottom`; seconds until the next one must go, negative where none will.
double drawToasts(Toasts& toasts, float right, float bottom);

}  // namespace sonoskin::ui
