#pragma once

#include "app/window/event_queue.h"
#include "app/workspace/workspace.h"

namespace sonoskin {

// MenuKeys: menus and open lists by keyboard. F10, or Alt alone, opens the first menu, Alt with a letter the menu that begins with
// it; while a list is open the keys are its own, and Escape closes it and ends nothing else.
class MenuKeys {
 public:
  // beforeFrame: before the interface's frame begins.
  void beforeFrame();
  // take: what an event does to menus, once its frame has begun; true when nobody else is to have it.
  bool take(const Event& event, Workspace& workspace);

 private:
  bool altAlone(const Event& event);

  int lists_ = 0;  // open before the frame
  bool alt_ = false;
};

}  // namespace sonoskin
