#pragma once

#include "core/skin/profile_curves.h"

namespace sonoskin::ui {

// ProfilePlot: what stays from frame to frame: the curves of the last options, and how they are drawn.
struct ProfilePlot {
  SkinOptions of;
  ProfileCurves curves = makeProfileCurves(of);
  bool logarithmic = true;
};

// drawProfilePlot: how far red, green and blue light go below the skin: target and fit over 0 to 10 mm, the
// error of the fit below, the radii that hold half and nine tenths of the light, and the Gaussians.
void drawProfilePlot(ProfilePlot& plot, const SkinOptions& options);

}  // namespace sonoskin::ui
