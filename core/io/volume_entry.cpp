#include "core/io/volume_entry.h"

#include <fmt/format.h>

namespace sonoskin {

std::string entryText(const VolumeEntry& entry) {
  std::string text = fmt::format("{} x {} x {}", entry.dims.x, entry.dims.y, entry.dims.z);
  if (!entry.modality.empty()) text += ", " + entry.modality;
  if (entry.timeSteps > 1) text += fmt::format(", {} time steps", entry.timeSteps);
  return text;
}

std::string entriesText(const std::vector<VolumeEntry>& entries) {
  std::string text;
  for (std::size_t n = 0; n < entries.size(); ++n)
    text += fmt::format("{}{}: {}", n > 0 ? "; " : "", n + 1, entryText(entries[n]));
  return text;
}

}  // namespace sonoskin
