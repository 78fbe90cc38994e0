#pragma once

#include "app/settings.h"

namespace sonoskin {

// QualityChooser: how fine skin is drawn, from how long pictures take. It begins with light quality; a machine that
// draws that at once is tried with full quality and keeps it where a picture takes less than kFluent.
class QualityChooser {
 public:
  static constexpr double kFluent = 0.030, kAtOnce = 0.010;  // seconds

  // full: the quality to use.
  bool full(SkinQualityChoice choice) const;
  // measured: a picture over the whole view took so long, with the quality that was used.
  void measured(bool full, double seconds);

 private:
  bool full_ = false, tooSlow_ = false;
};

}  // namespace sonoskin
