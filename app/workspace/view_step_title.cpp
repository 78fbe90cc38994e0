#include "app/workspace/view_step_title.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "app/texts/texts.h"

namespace sonoskin {
namespace {

using Measures = std::vector<Measure>;

std::string nameOf(const Measure& measure) {
  constexpr std::array<const char*, 3> kKinds{"Distance", "Angle", "Area"};
  return fmt::format("{} {}", tr(kKinds[std::size_t(measure.kind)]), measureText(measure));
}

std::string movedTitle(const Measures& before, const Measures& after) {
  const auto [was, is] = std::ranges::mismatch(before, after);
  const std::string past = measureText(*was), present = measureText(*is);
  return past == present ? fmt::format(fmt::runtime(tr("{}: mark moved")), nameOf(*is))
                         : fmt::format("{} → {}", nameOf(*was), present);
}

std::string measuresTitle(const Measures& before, const Measures& after) {
  if (after.size() > before.size()) return nameOf(after.back());
  if (after.size() == before.size()) return movedTitle(before, after);
  if (after.empty() && before.size() > 1) return tr("All marks deleted");
  const auto gone = std::ranges::mismatch(before, after).in1;
  return fmt::format(fmt::runtime(tr("{} deleted")), nameOf(*gone));
}

std::string clipTitle(const ClipShow& before, const ClipShow& after) {
  if (before.on != after.on) return after.on ? tr("Clip plane") : tr("Clip plane off");
  if (after.plane.normal == before.plane.normal) return tr("Clip plane moved");
  return after.plane.normal == -before.plane.normal ? tr("Clip plane: the other side")
                                                    : tr("Clip plane turned");
}

std::string coloursTitle(const VolumeColours& before, const VolumeColours& after) {
  if (before.name == after.name) return after.changed ? tr("Colours edited") : tr("Colours as they were");
  std::string name = after.name;
  if (findTransferPreset(name)) {
    name.front() = char(std::toupper(static_cast<unsigned char>(name.front())));
    name = tr(name.c_str());
  }
  return fmt::format(fmt::runtime(tr("Colours: {}")), name);
}

}  // namespace

std::string viewStepTitle(const ViewEdits& before, const ViewEdits& after) {
  if (before.measures != after.measures) return measuresTitle(before.measures, after.measures);
  if (!(before.clip == after.clip)) return clipTitle(before.clip, after.clip);
  return coloursTitle(before.colours, after.colours);
}

}  // namespace sonoskin
