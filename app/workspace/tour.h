#pragma once

#include <array>
#include <span>

#include "app/workspace/step.h"

namespace sonoskin {

struct Workspace;

// TourCard: one step of the tour through the window.
//   step   whose parameters are to be seen
//   shows  the names of the widgets that it speaks of, as noteWidget() has them; empty ones are none
struct TourCard {
  const char *title, *text;
  Step step;
  std::array<const char*, 4> shows;
};
std::span<const TourCard> tourCards();

// startTour: on the phantom, which is opened, after a question where work would be lost, unless it is there.
void startTour(Workspace& workspace);
// stepTour: to the next card or the one before; behind the last one it ends. There must be a tour.
void nextCard(Workspace& workspace);
void previousCard(Workspace& workspace);
void endTour(Workspace& workspace);
bool canGoBack(const Workspace& workspace);
bool onTour(const Workspace& workspace);

// offerTour: once, at a person's first start.
void offerTour(Workspace& workspace);

}  // namespace sonoskin
