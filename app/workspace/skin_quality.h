#pragma once

#include "app/workspace/settings.h"

namespace sonoskin {

// SkinTimes: what skin costs on this machine, seconds.
//   picture  a picture over the whole view, its light being there
//   light    all passes of the light
struct SkinTimes {
  double picture = 0, light = 0;
};

// QualityChooser: how fine skin is drawn, from how long that takes. It begins with light quality; a machine that does
// that at once is tried with full quality, and keeps it where pictures come in kFluent and light in kPrompt.
class QualityChooser {
 public:
  static constexpr double kFluent = 0.030, kPrompt = 0.200;

  // full: the quality to use.
  bool full(SkinQualityChoice choice) const;
  // measured: what it took with the quality that was used.
  void measured(bool full, const SkinTimes& times);

 private:
  bool full_ = false, tooSlow_ = false;
};

}  // namespace sonoskin
