#include "app/workspace/skin_quality.h"

namespace sonoskin {

bool QualityChooser::full(SkinQualityChoice choice) const {
  return choice == SkinQualityChoice::automatic ? full_ : choice == SkinQualityChoice::full;
}

void QualityChooser::measured(bool full, const SkinTimes& times) {
  // Four times the texels and often several times the triangles.
  const double share = full ? 1 : 0.25;
  const bool fast = times.picture < share * kFluent && times.light < share * kPrompt;
  if (full) {
    tooSlow_ = !fast;
    full_ = fast;
  } else if (fast && !tooSlow_) {
    full_ = true;
  }
}

}  // namespace sonoskin
