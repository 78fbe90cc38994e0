#include "app/skin_quality.h"

namespace sonoskin {

bool QualityChooser::full(SkinQualityChoice choice) const {
  return choice == SkinQualityChoice::automatic ? full_ : choice == SkinQualityChoice::full;
}

void QualityChooser::measured(bool full, double seconds) {
  if (full) {
    tooSlow_ = seconds > kFluent;
    full_ = !tooSlow_;
  } else if (seconds < kAtOnce && !tooSlow_) {
    full_ = true;
  }
}

}  // namespace sonoskin
