#pragma once

#include <cstddef>
#include <span>

#include "app/views/moving_budget.h"

namespace sonoskin::ui {

// FrameShare: what a 3D view may take of a frame that others share with it.
//   seconds  for a picture of something that moves
//   refines  whether it may make the picture of something that rests better; else another view does
//   moves    another of them moves the camera that all have
struct FrameShare {
  double seconds = 0.045;
  bool refines = true, moves = false;
};

// SharingView: what counts of a view: how its last frame was.
//   pictureSeconds  that its picture took; 0: it drew none
//   moving          something moved in it
//   unfinished      a better picture of what rests is on its way
struct SharingView {
  double pictureSeconds = 0;
  bool moving = false, unfinished = false;
};

// shareFrame: shares the next frame among views with one camera, so that it is as short as with one view alone: drafts have
// equal parts of its time, and pictures that rest become better one after the other.
//   input  frameSeconds  that the window took for its last frame
//          budget        of all of them
void shareFrame(std::span<const SharingView> views, double frameSeconds, MovingBudget& budget,
                std::span<FrameShare> shares);

}  // namespace sonoskin::ui
