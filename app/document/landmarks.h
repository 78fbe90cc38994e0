#pragma once

#include <array>

#include "core/skin/landmark_options.h"

namespace sonoskin {

// NamedLandmark: one of LandmarkOptions, with its name for people.
struct NamedLandmark {
  const char* name;
  std::array<double, 3> LandmarkOptions::*place;
};

inline constexpr std::array<NamedLandmark, 5> kLandmarks{{{"Right eye", &LandmarkOptions::rightEye},
                                                          {"Left eye", &LandmarkOptions::leftEye},
                                                          {"Tip of the nose", &LandmarkOptions::noseTip},
                                                          {"Mouth, right", &LandmarkOptions::mouthRight},
                                                          {"Mouth, left", &LandmarkOptions::mouthLeft}}};

}  // namespace sonoskin
