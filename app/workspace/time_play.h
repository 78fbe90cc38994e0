#pragma once

#include "app/document/step_range.h"
#include "core/base/timer.h"

namespace sonoskin {

struct Workspace;

// TimePlay: a recording that is played: one time step after another, over and over, each as soon as what is seen of the one
// before is complete.
//   first, last  the steps that are played, counted from 1; last 0: to the end
struct TimePlay {
  bool on = false;
  int first = 1, last = 0;
  Timer sinceStep{};
};

// showStep: another time step, as one edit.
void showStep(Workspace& workspace, int time);
// stepBy: the next (1) or the one before (-1), from the end to the beginning.
void stepBy(Workspace& workspace, int steps);
// play: begins or stops.
void play(Workspace& workspace, bool on);
// stepsOf: the steps that are played, within those of the recording.
StepRange stepsOf(const Workspace& workspace);
// playOn: shows the next step where its turn has come; stops where one cannot be read.
//   output  seconds until it has to be called again; negative: not at all
double playOn(Workspace& workspace);

}  // namespace sonoskin
