#pragma once

#include <vector>

namespace sonoskin {

// BlurKernel: one direction of a Gaussian blur as taps at even distances.
//   places   in standard deviations from the middle, of taps 0, 1, 2, ...; those on the other side mirror them
//   weights  of the same; weights[0] + 2 (weights[1] + ...) = 1
struct BlurKernel {
  std::vector<float> places, weights;
};

// makeBlurKernel: a Gaussian sampled `spacing` standard deviations apart out to 3.5, times the a + b x^2 that brings its sum
// and its variance to 1.                                                                         [theory/skin.md, 5.2]
//   spacing  1/6 to 1
BlurKernel makeBlurKernel(double spacing);

// blurSpacing: how far apart taps may be so that sharp shadows do not become stairs, in standard deviations: 1.5 texels
// or twice the width of what was blurred before (repeats of its spectrum are below 1 % then), and no more than 1.
//   sigma, texel, smoothed   mm; smoothed: standard deviation of the blurs before
double blurSpacing(double sigma, double texel, double smoothed);

}  // namespace sonoskin
