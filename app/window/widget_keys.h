#pragma once

#include "app/widgets/open_lists.h"
#include "app/window/event_queue.h"

namespace sonoskin {

// WidgetKeys: the side panel by keyboard. Tab takes the keys into it and goes to its next widget, Shift+Tab back; arrows go, too;
// the space bar or Enter does what the mouse would. Escape or a click gives the keys back to the views. In a question Tab goes to
// all that can be pressed or typed.
class WidgetKeys {
 public:
  // take: what an event does, once its frame has begun; true when nobody else is to have it.
  bool take(const Event& event);
  // steps: whether the next frames go to another widget of a question, and no other event is to come in between.
  bool steps() const { return questionStep_ != 0; }
  // forFrame: for the frame that begins.
  ui::KeySteering forFrame();

 private:
  bool takeTab(bool back);

  bool on_ = false;
  int step_ = 0, questionStep_ = 0;  // to the next widget or the one before, in the next frame
};

}  // namespace sonoskin
