#include "app/document/measure_file.h"
#include "app/texts/texts.h"
#include "app/views/measure_marks.h"
#include "app/views/tools.h"
#include "app/widgets/theme.h"

namespace sonoskin::ui {
namespace {

constexpr float kReach = 7;  // from a mark to the mouse that takes it; a shorter drag is a click

// The mark below the mouse, of the measures that the slice shows.
std::optional<ToolState::Mark> markBelow(const Workspace& w, const ToolPane& pane) {
  const Geometry& g = w.session.scan().volume->geometry;
  const SliceFrame& frame = pane.slice->frame;
  for (std::size_t m = 0; m < w.view.measures.size(); ++m)
    for (std::size_t n = 0; n < w.view.measures[m].marks.size(); ++n) {
      const glm::dvec3& mark = w.view.measures[m].marks[n];
      if (isInSlice(mark, frame, g) &&
          glm::distance(glm::vec2(frame.toPixel(mark)), pane.input.mouse) < kReach * unit())
        return ToolState::Mark{m, n};
    }
  return std::nullopt;
}

void finish(ViewState& view) {
  if (view.measureBegun && isComplete(*view.measureBegun)) view.measures.push_back(*view.measureBegun);
  view.measureBegun.reset();
}

// Whether a click at the first mark, or a double click, closes the border of an area.
bool closes(const Measure& begun, const ToolPane& pane) {
  if (begun.kind != MeasureKind::area || !isComplete(begun)) return false;
  const glm::vec2 first(pane.slice->frame.toPixel(begun.marks.front()));
  return pane.input.doubleClicked || glm::distance(first, pane.input.mouse) < kReach * unit();
}

// What a session would not hold is not begun.
bool isThereRoom(Workspace& w) {
  if (w.view.measures.size() < kMostMeasures) return true;
  w.toasts.warn(
      trf("There are {} measures, as many as a session holds; take one away first.", kMostMeasures));
  return false;
}

void addMark(Workspace& w, const ToolPane& pane) {
  ViewState& view = w.view;
  if (!isThereRoom(w)) return;
  const glm::dvec3 at = pane.slice->frame.toWorld(glm::dvec2(pane.input.mouse));
  // What was begun of another kind is given up.
  auto& begun = view.measureBegun;
  if (begun && begun->kind != view.measuring) begun.reset();
  if (!begun) begun = Measure{view.measuring, {}};
  if (closes(*begun, pane)) return finish(view);
  begun->marks.push_back(at);
  if (isFull(*begun) || begun->marks.size() >= kMostMarks) finish(view);
}

// What was begun in another slice is given up: its marks would not lie in one.
bool isBegunElsewhere(const Workspace& w, const ToolPane& pane) {
  const auto& begun = w.view.measureBegun;
  return begun && !begun->marks.empty() &&
         !isInSlice(begun->marks.front(), pane.slice->frame, w.session.scan().volume->geometry);
}

}  // namespace

PaneInput useMeasureTool(ToolState& state, Workspace& w, const ToolPane& pane) {
  const PaneInput& input = pane.input;
  if (!holdsLeft(input) || (!state.held && (input.shift || !input.pressed))) return input;
  if (!state.held) {
    state.held = Tool::measure;
    state.stroke.from = input.mouse;
    state.mark = w.view.measureBegun ? std::nullopt : markBelow(w, pane);
    if (isBegunElsewhere(w, pane)) w.view.measureBegun.reset();
    if (!state.mark) addMark(w, pane);
  } else if (state.mark && state.mark->measure < w.view.measures.size()) {
    w.view.measures[state.mark->measure].marks[state.mark->number] =
        pane.slice->frame.toWorld(glm::dvec2(input.mouse));
  }
  return withoutButton(input);
}

// A drag sets both of its ends.
void letGoMeasureTool(ToolState& state, Workspace& w, const ToolPane& pane) {
  const bool dragged = glm::distance(pane.input.mouse, state.stroke.from) > kReach * unit();
  const bool line = w.view.measureBegun && w.view.measureBegun->kind != MeasureKind::area;
  if (!state.mark && dragged && line) addMark(w, pane);
  state.mark.reset();
}

}  // namespace sonoskin::ui
