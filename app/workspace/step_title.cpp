#include "app/workspace/step_title.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "app/texts/texts.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"
#include "app/workspace/view_step_title.h"
#include "core/pipeline/presets.h"
#include "core/pipeline/stage_keys.h"

namespace sonoskin {
namespace {

// Change: a parameter of two values.
struct Change {
  std::string_view group;
  Field field;
  std::string before, after;
};

template <class T>
std::string valueText(const T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    return value ? tr("on") : tr("off");
  } else if constexpr (NamedEnum<T>) {
    return tr(enumNames(value)[std::size_t(value)]);
  } else if constexpr (std::is_same_v<T, double>) {
    return fmt::format("{:.4g}", value);
  } else if constexpr (std::is_same_v<T, int>) {
    return std::to_string(value);
  } else if constexpr (std::is_same_v<T, Places>) {
    std::string text;
    for (const auto& place : value) text += fmt::format("({}) ", fmt::join(place, ", "));
    return text;
  } else {
    std::string text;
    for (const auto element : value) text += (text.empty() ? "" : ", ") + valueText(element);
    return text;
  }
}

// Both visits go through the same list in the same order.
std::vector<Change> changesBetween(const Parameters& before, const Parameters& after) {
  std::vector<Change> all;
  forEachField(
      [&](const Group& group, const Field& field, const auto& value, auto...) {
        all.push_back({group.name, field, valueText(value), {}});
      },
      before);
  std::size_t n = 0;
  forEachField(
      [&](const Group&, const Field&, const auto& value, auto...) { all[n++].after = valueText(value); },
      after);
  std::erase_if(all, [](const Change& c) { return c.before == c.after; });
  return all;
}

std::string erasedTitle(std::size_t before, std::size_t after) {
  if (after == 0) return tr("Nothing is erased any more");
  const char* text = after > before ? tr("Erased {} voxels") : tr("Brought {} voxels back");
  return fmt::format(fmt::runtime(text), ui::grouped(after > before ? after - before : before - after));
}

bool allAre(const std::vector<Change>& changes, std::string_view group, std::string_view start) {
  return std::ranges::all_of(
      changes, [&](const Change& c) { return c.group == group && c.field.name.starts_with(start); });
}

// What a click on a part, or a line across one, did to the lists of places; longer lists are longer texts.
std::string partsTitle(const std::vector<Change>& changes) {
  for (const Change& c : changes) {
    if (c.after.size() <= c.before.size()) continue;
    if (c.field.name == "partsCut") return tr("Part split");
    if (c.field.name == "partsDrop") return tr("Part taken away");
    if (c.field.name == "partsAdd") return tr("Part brought back");
  }
  return tr("Parts chosen");
}

std::string oneTitle(const Change& c) {
  if (c.group == "scan" && c.field.name == "time") return trf("Time step {} → {}", c.before, c.after);
  const std::string symbol = ui::greekSymbol(c.field.symbol);
  const std::string name = symbol.empty() ? ui::fieldLabel(c.field) : symbol;
  return fmt::format("{} {} → {}", name, c.before, c.after);
}

std::string severalTitle(const std::vector<Change>& changes, const Parameters& after) {
  if (parametersKey(after) == parametersKey({})) return tr("All parameters to their defaults");
  if (const Preset* preset = matchingPreset(after); preset && changes.size() > 1) {
    const std::string_view first = changes.front().group;
    if (first == "classification" || first == "surface" || first == "reconstruction")
      return trf("Preset {}", ui::presetTitle(preset->name));
  }
  return trf("{} and {} more", oneTitle(changes.front()), changes.size() - 1);
}

}  // namespace

std::string stepTitle(const Version& before, const Version& after) {
  const std::vector<Change> changes = changesBetween(before.parameters, after.parameters);
  if (changes.empty() && !(before.views == after.views)) return viewStepTitle(before.views, after.views);
  if (changes.empty()) return erasedTitle(before.erased, after.erased);
  if (allAre(changes, "region", "")) return tr("Crop box");
  if (allAre(changes, "landmarks", "")) return tr("Landmark");
  if (allAre(changes, "mesh", "parts")) return partsTitle(changes);
  return changes.size() == 1 ? oneTitle(changes.front()) : severalTitle(changes, after.parameters);
}

}  // namespace sonoskin
