#include "app/workspace/step.h"

#include "app/texts/texts.h"

namespace sonoskin {

const char* stepName(Step step) {
  static constexpr std::array<const char*, kSteps.size()> kNames{"volume",  "region", "classify",
                                                                 "surface", "skin",   "export"};
  return kNames[std::size_t(step)];
}

const char* stepTitle(Step step) {
  static constexpr std::array<const char*, kSteps.size()> kTitles{"Volume",  "Region", "Classify",
                                                                  "Surface", "Skin",   "Export"};
  return tr(kTitles[std::size_t(step)]);
}

const char* stepHelp(Step step) {
  static constexpr std::array<const char*, kSteps.size()> kHelps{
      "What is open, and how it was recorded.", "The part of the volume that may become surface.",
      "Finds surfaces in the noise.",           "Fits a smooth surface to what was found.",
      "What the surface looks like as skin.",   "Surfaces, pictures and volumes for others."};
  return tr(kHelps[std::size_t(step)]);
}

}  // namespace sonoskin
