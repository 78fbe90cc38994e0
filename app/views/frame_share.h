#pragma once

#include <cstddef>
#include <span>

#include "app/views/moving_budget.h"

namespace sonoskin::ui {

// FrameShare: what a 3D view may take of a frame that others share with it.
//   seconds  for a picture of something that moves
//   refines  whether it may make the picture of something that rests better; else another view does
//   moves    another of them moves the camera that all have
//   draws    whether it may draw while another moves it; else it keeps its picture for this frame
struct FrameShare {
  double seconds = 0.045;
  bool refines = true, moves = false, draws = true;
};

// SharingView: what counts of a view: how its last frame was.
//   pictureSeconds  that its picture took; 0: it drew none
//   moving          something moved in it
//   draftSeconds    that its last draft took
//   unfinished      a better picture of what rests is on its way
struct SharingView {
  double pictureSeconds = 0, draftSeconds = 0;
  bool moving = false, unfinished = false;
};

// SharedTime: what views with one camera have in common.
//   turn  of those that are moved by another, which one draws
struct SharedTime {
  MovingBudget budget;
  std::size_t turn = 0;
};

// shareFrame: shares the next frame among views with one camera, so that it is as short as with one view alone: drafts have
// equal parts of its time, and pictures that rest become better one after the other. Where the coarsest drafts of all are too
// much for a frame, those that are moved by another take turns.
//   input  frameSeconds  that the window took for its last frame
void shareFrame(std::span<const SharingView> views, double frameSeconds, SharedTime& shared,
                std::span<FrameShare> shares);

}  // namespace sonoskin::ui
