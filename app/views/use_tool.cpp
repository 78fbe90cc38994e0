#include "app/views/use_tool.h"

#include <algorithm>
#include <array>

#include "app/views/scene.h"
#include "app/views/steering.h"

namespace sonoskin::ui {
namespace {

// ToolInPane: what a tool does in views of one kind; where `use` is null it leaves the mouse to the view.
struct ToolInPane {
  PaneInput (*use)(ToolState&, Workspace&, const ToolPane&) = nullptr;
  void (*letGo)(ToolState&, Workspace&, const ToolPane&) = nullptr;
  void (*draw)(const ToolState&, const Workspace&, const ToolPane&) = nullptr;
};

// ToolRow: a tool in both kinds of views.
//   chosen        only where a person has chosen it for views of that kind
//   isShown       whether what it works on is shown
//   doubleClicks  see takesDoubleClicks
struct ToolRow {
  Tool tool;
  bool chosen;
  bool (*isShown)(const Workspace&);
  ToolInPane inSlices, inSpace;
  bool doubleClicks = false;
};

bool showsBox(const Workspace& w) { return w.view.cropBox; }
bool clips(const Workspace& w) { return w.view.clip.on; }
bool showsOblique(const Workspace& w) { return w.settings.layout.layout == Layout::oblique; }
bool always(const Workspace&) { return true; }
PaneInput steerAlone(ToolState&, Workspace&, const ToolPane& pane) { return pane.input; }

constexpr ToolInPane kNothing{}, kSteering{steerAlone}, kLandmark{useLandmarkTool},
    kEraser{useEraser, letGoEraser, drawEraser}, kLasso{useLasso, letGoLasso, drawLasso},
    kMeasure{useMeasureTool, letGoMeasureTool}, kParts{usePartTool, letGoPartTool, drawPartTool},
    kLamp{useLampTool, letGoLampTool}, kBox{useCropBoxTool, letGoCropBoxTool, drawCropBoxTool},
    kFaces{useCropFaces, letGoCropBoxTool}, kClip{useClipTool}, kOblique{useObliqueTool};

// clang-format off
constexpr std::array<ToolRow, kTools.size()> kRows{{
    //               chosen isShown     in slices  in 3D      doubleClicks
    {Tool::landmark,  true, wantsSkin,  kNothing,  kLandmark},
    {Tool::eraser,    true, always,     kEraser,   kNothing,  true},
    {Tool::lasso,     true, always,     kLasso,     kLasso,    true},
    {Tool::measure,   true, always,     kMeasure,  kNothing,  true},
    {Tool::parts,    false, showsParts, kNothing,  kParts,    true},
    {Tool::lamp,     false, wantsSkin,  kNothing,  kLamp},
    {Tool::clipPlane,false, clips,      kNothing,  kClip},
    {Tool::oblique,  false, showsOblique, kOblique,  kNothing},
    {Tool::cropBox,  false, showsBox,   kBox,      kFaces},
    {Tool::crossHair, false, always,    kSteering, kSteering},
}};
// clang-format on
static_assert(std::ranges::equal(kRows, kTools, {}, &ToolRow::tool));

const ToolRow& rowOf(Tool tool) { return *std::ranges::find(kRows, tool, &ToolRow::tool); }

PaneKind kindOf(const ToolPane& pane) { return pane.slice ? PaneKind::slice : PaneKind::space; }

const ToolInPane& inPane(const ToolRow& row, PaneKind kind) {
  return kind == PaneKind::slice ? row.inSlices : row.inSpace;
}

bool isUsable(const ToolRow& row, const Workspace& w, PaneKind kind) {
  const Tool chosen = kind == PaneKind::slice ? w.view.sliceTool : w.view.spaceTool;
  return inPane(row, kind).use && (!row.chosen || chosen == row.tool) && row.isShown(w);
}

const ToolRow& firstRow(const Workspace& w, PaneKind kind) {
  return *std::ranges::find_if(kRows, [&](const ToolRow& row) { return isUsable(row, w, kind); });
}

// What is left of the mouse. A tool that is not chosen and does not take the button leaves it to those after it.
PaneInput useAll(ToolState& state, Workspace& w, const ToolPane& pane) {
  const PaneKind kind = kindOf(pane);
  if (state.held) return inPane(rowOf(*state.held), kind).use(state, w, pane);
  ToolPane left = pane;
  for (const ToolRow& row : kRows) {
    if (!isUsable(row, w, kind)) continue;
    left.input = inPane(row, kind).use(state, w, left);
    if (state.held || row.chosen || row.tool == Tool::parts) break;
  }
  return left.input;
}

void letGo(ToolState& state, Workspace& w, const ToolPane& pane) {
  if (const auto letGoOf = inPane(rowOf(*state.held), kindOf(pane)).letGo) letGoOf(state, w, pane);
  state.held.reset();
}

}  // namespace

Tool toolIn(const Workspace& workspace, PaneKind kind) { return firstRow(workspace, kind).tool; }

void useTool(ToolState& state, Workspace& workspace, const ToolPane& pane) {
  const bool held = state.held.has_value();
  if (held && (!holdsLeft(pane.input) || !isUsable(rowOf(*state.held), workspace, kindOf(pane))))
    letGo(state, workspace, pane);
  const PaneInput left = useAll(state, workspace, pane);
  if (held || state.held) workspace.view.toolHeld = state.held.has_value();
  if (pane.slice) {
    steerSlice(workspace.view, pane.slice->plane, workspace.session.scan().volume->geometry, state.turns,
               left);
  } else if (steer(workspace.view.camera, left)) {
    workspace.view.cameraMoved = true;
  }
}

void drawTool(const ToolState& state, const Workspace& workspace, const ToolPane& pane) {
  const PaneKind kind = kindOf(pane);
  for (const ToolRow& row : kRows) {
    const bool has = state.held ? row.tool == *state.held : isUsable(row, workspace, kind);
    if (!has) continue;
    if (const auto draw = inPane(row, kind).draw) return draw(state, workspace, pane);
    if (state.held || row.chosen) return;
  }
}

bool takesDoubleClicks(const Workspace& workspace, PaneKind kind) {
  return firstRow(workspace, kind).doubleClicks;
}

}  // namespace sonoskin::ui
