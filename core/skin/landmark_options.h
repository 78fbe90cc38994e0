#pragma once

#include <array>

#include "core/base/fields.h"

namespace sonoskin {

// LandmarkOptions: places of the face that give lips, lids and cheeks their colour; 0 0 0: not set. Lips need both
// corners of the mouth; lids the eyes; cheeks both.
struct LandmarkOptions {
  std::array<double, 3> rightEye{0, 0, 0}, leftEye{0, 0, 0};
  std::array<double, 3> noseTip{0, 0, 0};
  std::array<double, 3> mouthRight{0, 0, 0}, mouthLeft{0, 0, 0};

  bool operator==(const LandmarkOptions&) const = default;
};

template <class F, class O>
requires OptionsOf<O, LandmarkOptions>
void fields(F&& f, O& o) {
  const Range range{-1e5, 1e5};
  f(Field{"rightEye", "middle of the right eye's lids (the patient's right); 0 0 0: not set", "mm"},
    o.rightEye, range);
  f(Field{"leftEye", "middle of the left eye's lids; 0 0 0: not set", "mm"}, o.leftEye, range);
  f(Field{"noseTip", "tip of the nose; 0 0 0: not set", "mm"}, o.noseTip, range);
  f(Field{"mouthRight", "right corner of the mouth; 0 0 0: not set", "mm"}, o.mouthRight, range);
  f(Field{"mouthLeft", "left corner of the mouth; 0 0 0: not set", "mm"}, o.mouthLeft, range);
}

// isSet: whether a landmark was placed.
inline bool isSet(const std::array<double, 3>& landmark) {
  return landmark[0] != 0 || landmark[1] != 0 || landmark[2] != 0;
}

}  // namespace sonoskin
