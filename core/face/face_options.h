#pragma once

#include "core/base/fields.h"

namespace sonoskin {

// FaceOptions: how the face is looked for.
struct FaceOptions {
  bool find = true;
  double confidence = 0.5;
  double headHeight = 85;

  bool operator==(const FaceOptions&) const = default;
};

template <class F, class O>
requires OptionsOf<O, FaceOptions>
void fields(F&& f, O& o) {
  f(Field{"find",
          "look for eyes, nose, mouth and chin: for the colour of lips, lids and cheeks, for the view, and "
          "for the parts that are kept"},
    o.find);
  f(Field{"confidence", "a face that is less certain than this is not used; 1: none is"}, o.confidence,
    Range{0.0, 1.0});
  f(Field{"headHeight", "height of a head as expected, from chin to crown", "mm"}, o.headHeight,
    Range{20.0, 300.0});
}

}  // namespace sonoskin
