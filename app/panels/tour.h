#pragma once

#include "app/widgets/widget_rects.h"
#include "app/workspace/workspace.h"

namespace sonoskin::ui {

// TourWindow: the cards of the tour, each beside what it speaks of, which is framed, and the offer of the tour. The window goes
// on as ever below them. It finds the rows of parameters that are looked for by name, too.
class TourWindow {
 public:
  // draw: after the rest of the frame; what it points at is noted from the frame after the first.
  void draw(Workspace& workspace);

 private:
  void lookForWidgets(bool on);
  void lookForRow(std::string& wanted);

  WidgetRects rects_;
};

}  // namespace sonoskin::ui
