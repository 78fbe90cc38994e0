#include "app/document/document_state.h"

#include <array>

namespace sonoskin {

DocumentState stateOf(const DocumentFacts& f) {
  using enum DocumentState;
  if (f.opening) return opening;
  if (f.working) return working;
  if (f.saving) return saving;
  if (!f.hasScan) return empty;
  if (f.stopped) return stopped;
  if (f.failed) return failed;
  if (!f.hasMesh) return noSurface;
  if (!f.meshIsCurrent) return older;
  return f.meshIsFinal ? current : live;
}

const char* stateText(DocumentState state) {
  static constexpr std::array<const char*, 10> kTexts{
      "Waiting for a volume",    "Opening",   "Working",        "Saving",
      "Stopped; press Continue", "Failed",    "No surface yet", "Surface older than the parameters",
      "Live, not yet final",     "Up to date"};
  return kTexts[static_cast<std::size_t>(state)];
}

}  // namespace sonoskin
