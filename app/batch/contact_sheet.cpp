#include "app/batch/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/error_text.h"
#include "core/base/log.h"
#include "core/pipeline/stage_keys.h"

namespace sonoskin {
namespace {

constexpr int kLargest = 16384;    // pixels a side, as readPng() reads
constexpr int kMargin = 16;        // pixels around the cells and between them
constexpr double kComputed = 0.8;  // share of a cell's time that its picture comes after
constexpr std::size_t kWide = 5;   // one axis of more values goes on in further rows

int captionOf(const SheetLayout& layout) { return 2 * layout.text; }

glm::ivec2 gridOf(const std::vector<SheetAxis>& axes) {
  const int count = int(axes[0].values.size());
  if (axes.size() == 2) return {count, int(axes[1].values.size())};
  if (std::size_t(count) <= kWide) return {count, 1};
  const int columns = int(std::ceil(std::sqrt(double(count))));
  return {columns, (count + columns - 1) / columns};
}

std::vector<SheetCell> cellsOf(const std::vector<SheetAxis>& axes) {
  std::vector<SheetCell> cells;
  const std::size_t rows = axes.size() == 2 ? axes[1].values.size() : 1;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < axes[0].values.size(); ++column) {
      SheetCell cell;
      cell.values.push_back(column);
      if (axes.size() == 2) cell.values.push_back(row);
      cell.text = cellText(axes, cell.values);
      cell.current = true;
      for (std::size_t a = 0; a < axes.size(); ++a) cell.current &= axes[a].current == cell.values[a];
      cells.push_back(std::move(cell));
    }
  return cells;
}

// How many stages of the pipeline are made anew where an axis goes on: the earlier the first of them, the more.
int stagesOver(const SheetOrder& order, std::size_t axis) {
  std::vector<std::size_t> values(order.axes.size(), 0);
  const auto keys = [&] {
    const StageKeys k =
        stageKeys(order.scan.key, order.scan.erasedKey, withValues(order.parameters, order.axes, values));
    return std::array{k.enhanced, k.prepared, k.classified, k.points, k.fit, k.pieces, k.kept, k.mesh};
  };
  const auto first = keys();
  values[axis] = order.axes[axis].values.size() - 1;
  const auto last = keys();
  int changed = 0;
  for (std::size_t k = 0; k < first.size(); ++k) changed += first[k] != last[k];
  return changed;
}

// In which order the cells are made: what changes the earlier stages changes least often.
std::vector<std::size_t> orderOf(const SheetOrder& order, const ContactSheet& sheet) {
  std::vector<std::size_t> cells(sheet.cells.size());
  for (std::size_t n = 0; n < cells.size(); ++n) cells[n] = n;
  if (order.axes.size() == 2 && stagesOver(order, 0) > stagesOver(order, 1))
    std::ranges::stable_sort(cells, {}, [&](std::size_t n) { return sheet.cells[n].values[0]; });
  return cells;
}

// SheetMaker: what the cells share.
struct SheetMaker {
  gl::Context& context;
  const SheetOrder& order;
  ContactSheet& sheet;
  Pipeline pipeline{};
  std::set<std::string> warned{};

  void noteStages(const std::vector<StageReport>& stages) {
    for (const StageReport& stage : stages) {
      auto same = std::ranges::find(sheet.stages, stage.name, &StageReport::name);
      if (same == sheet.stages.end()) same = sheet.stages.insert(same, {stage.name, 0, 0});
      same->seconds += stage.seconds;
      same->bytes = std::max(same->bytes, stage.bytes);
    }
  }
  void make(SheetCell& cell, const Progress& progress);
};

// ReleasedAfter: between pictures others may draw with the context.
struct ReleasedAfter {
  gl::Context& context;
  ~ReleasedAfter() { context.release(); }
};

void SheetMaker::make(SheetCell& cell, const Progress& progress) try {
  ScanMade made{order.scan, {}, withValues(order.parameters, order.axes, cell.values)};
  if (const auto goal = goalOf(order.view)) {
    made.results = pipeline.run(made.scan, made.parameters, *goal, progress.part(0, kComputed));
    noteStages(made.results.stages);
    for (const std::string& warning : made.results.warnings)
      if (warned.insert(warning).second) log(LogLevel::warning, asSentence(warning));
  }
  const ReleasedAfter drawn{context};
  cell.picture = pictureOfScan(context, std::move(made), order.view, progress.part(kComputed, 1));
} catch (const Error& error) {
  if (error.kind() != Error::Kind::input) throw;
  cell.failure = asSentence(error.what());
}

}  // namespace

glm::ivec2 SheetLayout::corner(std::size_t n) const {
  const glm::ivec2 place(int(n) % grid.x, int(n) / grid.x);
  return kMargin + place * (cell + glm::ivec2(kMargin, captionOf(*this) + kMargin / 2));
}

glm::ivec2 SheetLayout::size() const {
  return corner(std::size_t(grid.x * grid.y) - 1) + cell +
         glm::ivec2(kMargin, captionOf(*this) + kMargin / 2);
}

std::optional<std::size_t> SheetLayout::at(glm::vec2 place) const {
  for (std::size_t n = 0; n < std::size_t(grid.x * grid.y); ++n) {
    const glm::vec2 least(corner(n)), most = least + glm::vec2(cell + glm::ivec2(0, captionOf(*this)));
    if (glm::all(glm::greaterThanEqual(place, least)) && glm::all(glm::lessThan(place, most))) return n;
  }
  return {};
}

SheetLayout sheetLayout(const std::vector<SheetAxis>& axes, glm::ivec2 cell) {
  if (axes.empty() || axes.size() > 2)
    throw Error("A contact sheet goes over one or two parameters; give --over once or twice.",
                Error::Kind::usage);
  if (axes.size() == 2 && axes[0].parameter == axes[1].parameter)
    throw Error(fmt::format("--over names {} twice; give all its values at once.", axes[0].parameter),
                Error::Kind::usage);
  SheetLayout layout{gridOf(axes), cell};
  layout.text = std::clamp(cell.x / 18, 11, 40);
  if (const glm::ivec2 size = layout.size(); size.x > kLargest || size.y > kLargest)
    throw Error(
        fmt::format("The sheet would have {} x {} pixels, and {} a side are the most; give fewer values "
                    "or a smaller --size.",
                    size.x, size.y, kLargest),
        Error::Kind::usage);
  return layout;
}

ContactSheet makeSheet(gl::Context& context, const SheetOrder& order, const Progress& progress,
                       const std::function<void(const std::string&)>& cellBegins) {
  ContactSheet sheet{sheetLayout(order.axes, order.view.picture.size), cellsOf(order.axes), {}};
  SheetMaker maker{context, order, sheet};
  const double share = 1 / double(sheet.cells.size());
  double done = 0;
  for (const std::size_t n : orderOf(order, sheet)) {
    SheetCell& cell = sheet.cells[n];
    if (cellBegins)
      cellBegins(fmt::format("{:.0f} of {}: {}", done / share + 1, sheet.cells.size(), cell.text));
    maker.make(cell, progress.part(done, done + share));
    done += share;
    progress.update(done);
  }
  if (std::ranges::all_of(sheet.cells, [](const SheetCell& cell) { return !cell.failure.empty(); }))
    throw Error(sheet.cells.front().failure);
  return sheet;
}

}  // namespace sonoskin
