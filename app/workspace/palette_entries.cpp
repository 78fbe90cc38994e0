#include "app/workspace/palette_entries.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "app/texts/texts.h"
#include "app/widgets/fields_ui.h"
#include "app/workspace/command_tables.h"
#include "app/workspace/word_match.h"
#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

constexpr int kPlaceCost = 100;  // of what is found by its menu or group alone: more than any jumps

struct Found {
  int misfit;
  PaletteEntry entry;
};

// The step whose panel has the rows of a group; nothing where they are no rows, but what is dragged or asked.
std::optional<Step> stepOf(std::string_view group) {
  struct Place {
    std::string_view group;
    Step step;
  };
  constexpr std::array<Place, 12> kPlaces{{{"phantom", Step::volume},
                                           {"scan", Step::volume},
                                           {"enhancement", Step::classify},
                                           {"classification", Step::classify},
                                           {"surface", Step::surface},
                                           {"reconstruction", Step::surface},
                                           {"global", Step::surface},
                                           {"mesh", Step::surface},
                                           {"face", Step::surface},
                                           {"print", Step::output},
                                           {"skin", Step::skin},
                                           {"light", Step::skin}}};
  const auto found = std::ranges::find(kPlaces, group, &Place::group);
  return found == kPlaces.end() ? std::nullopt : std::optional(found->step);
}

// By its own words, or else by those of its place.
std::optional<int> misfitAt(std::string_view words, const std::string& text, std::string_view place) {
  if (const std::optional<int> cost = misfit(words, text)) return cost;
  const std::optional<int> cost = misfit(words, fmt::format("{} {}", text, place));
  return cost ? std::optional(*cost + kPlaceCost) : std::nullopt;
}

void addCommands(std::string_view words, const Workspace& workspace, std::vector<Found>& found) {
  for (const Command& c : commands()) {
    const char* menu = tr(kMenuTitles[std::size_t(c.menu)]);
    const std::string title = commandTitle(c);
    const std::optional<int> cost = misfitAt(words, title, menu);
    if (!cost) continue;
    const char* lacks = whatLacks(c, workspace);
    found.push_back(
        {*cost,
         {c.id, title, *lacks ? lacks : menu, shortcutText(c.shortcut), isEnabled(c, workspace), c.run}});
  }
}

void addParameters(std::string_view words, std::vector<Found>& found) {
  Parameters parameters;
  forEachField(
      [&](const Group& group, const Field& field, auto&, auto...) {
        const std::optional<Step> step = stepOf(group.name);
        const std::string label = ui::fieldLabel(field), symbol = ui::greekSymbol(field.symbol);
        const std::optional<int> cost =
            misfitAt(words, fmt::format("{} {} {}", label, field.symbol, symbol), group.name);
        if (!step || !cost) return;
        const std::string id = fmt::format("{}.{}", group.name, field.name);
        const auto open = [id, step = *step](Workspace& w) {
          w.step = step;
          w.help.wantedRow = id;
        };
        found.push_back(
            {*cost, {id, symbol.empty() ? label : label + "  " + symbol, stepTitle(*step), "", true, open}});
      },
      parameters);
}

}  // namespace

std::vector<PaletteEntry> paletteEntries(std::string_view words, const Workspace& workspace) {
  std::vector<Found> found;
  addCommands(words, workspace, found);
  if (words.find_first_not_of(' ') != words.npos) {
    addParameters(words, found);
    std::ranges::stable_sort(found, [](const Found& a, const Found& b) {
      return a.misfit != b.misfit ? a.misfit < b.misfit : a.entry.enabled > b.entry.enabled;
    });
  }
  std::vector<PaletteEntry> entries;
  for (Found& f : found) entries.push_back(std::move(f.entry));
  return entries;
}

std::string commandTitle(const Command& c) {
  return c.submenu ? trf("{}: {}", tr(c.submenu), tr(c.title)) : tr(c.title);
}

const char* whatLacks(const Command& command, const Workspace& workspace) {
  struct Lack {
    bool (*enabled)(const Workspace&);
    const char* text;
  };
  constexpr std::array<Lack, 5> kLacks{{{hasScan, "no scan is open"},
                                        {hasMesh, "there is no surface yet"},
                                        {hasErased, "nothing is erased"},
                                        {hasSteps, "one time step alone"},
                                        {showsSkin, "3D does not show skin"}}};
  if (isEnabled(command, workspace)) return "";
  const auto found = std::ranges::find(kLacks, command.enabled, &Lack::enabled);
  return found == kLacks.end() ? "" : tr(found->text);
}

}  // namespace sonoskin
