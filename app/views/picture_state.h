#pragma once

#include "render/skin/skin_view.h"

namespace sonoskin::ui {

// PictureState: what the 3D view shows at a moment of what it is to show.
//   sampling   of its picture: nothing yet; fewer pixels than the view has; all of them; four samples for each
//   light      of skin that is shown; whatever else is shown has the best there is
//   moving     the camera, a tool or the light moves: drafts will do
//   unfinished the next frame draws a better picture
struct PictureState {
  enum class Sampling { none, draft, full, smooth };
  Sampling sampling = Sampling::none;
  LightState light = LightState::refined;
  bool moving = false, unfinished = false;

  // lighting: whether the light that is asked for is on its way, whose passes say nothing about the time of a picture.
  bool lighting() const { return light < LightState::complete; }
  // settled: whether this is the final picture.
  bool settled() const { return light == LightState::refined && !moving && !unfinished; }
};

}  // namespace sonoskin::ui
