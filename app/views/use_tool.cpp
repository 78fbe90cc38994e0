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
//   isUsable      whether it has something to do now
//   doubleClicks  see takesDoubleClicks
struct ToolRow {
  Tool tool;
  bool (*isUsable)(const Workspace&);
  ToolInPane inSlices, inSpace;
  bool doubleClicks = false;
};

bool placesLandmark(const Workspace& w) { return w.view.spaceTool == Tool::landmark && wantsSkin(w); }
bool erases(const Workspace& w) { return w.view.sliceTool == Tool::eraser; }
bool showsBox(const Workspace& w) { return w.view.cropBox; }
bool always(const Workspace&) { return true; }
PaneInput steerAlone(ToolState&, Workspace&, const ToolPane& pane) { return pane.input; }

constexpr ToolInPane kNothing{}, kErase{useEraser, letGoEraser, drawEraser},
    kParts{usePartTool, letGoPartTool, drawPartTool}, kLamp{useLampTool, letGoLampTool},
    kBox{useCropBoxTool, letGoCropBoxTool, drawCropBoxTool};

constexpr std::array<ToolRow, kTools.size()> kRows{{
    {Tool::landmark, placesLandmark, kNothing, {useLandmarkTool}},
    {Tool::eraser, erases, kErase, kNothing, true},
    {Tool::parts, showsParts, kNothing, kParts, true},
    {Tool::lamp, wantsSkin, kNothing, kLamp},
    {Tool::cropBox, showsBox, kBox, kNothing},
    {Tool::crossHair, always, {steerAlone}, {steerAlone}},
}};
static_assert(std::ranges::equal(kRows, kTools, {}, &ToolRow::tool));

const ToolRow& rowOf(Tool tool) { return *std::ranges::find(kRows, tool, &ToolRow::tool); }

PaneKind kindOf(const ToolPane& pane) { return pane.slice ? PaneKind::slice : PaneKind::space; }

const ToolInPane& inPane(const ToolRow& row, PaneKind kind) {
  return kind == PaneKind::slice ? row.inSlices : row.inSpace;
}

const ToolRow& firstRow(const Workspace& w, PaneKind kind) {
  return *std::ranges::find_if(kRows,
                               [&](const ToolRow& row) { return inPane(row, kind).use && row.isUsable(w); });
}

const ToolInPane& toolNow(const ToolState& state, const Workspace& w, PaneKind kind) {
  return inPane(state.held ? rowOf(*state.held) : firstRow(w, kind), kind);
}

void letGo(ToolState& state, Workspace& w, const ToolPane& pane) {
  if (const auto letGoOf = inPane(rowOf(*state.held), kindOf(pane)).letGo) letGoOf(state, w, pane);
  state.held.reset();
}

}  // namespace

Tool toolIn(const Workspace& workspace, PaneKind kind) { return firstRow(workspace, kind).tool; }

void useTool(ToolState& state, Workspace& workspace, const ToolPane& pane) {
  const bool held = state.held.has_value();
  if (held && (!holdsLeft(pane.input) || !rowOf(*state.held).isUsable(workspace)))
    letGo(state, workspace, pane);
  const PaneInput left = toolNow(state, workspace, kindOf(pane)).use(state, workspace, pane);
  if (held || state.held) workspace.view.toolHeld = state.held.has_value();
  if (pane.slice) {
    steerSlice(workspace.view, pane.slice->plane, workspace.session.scan().volume->geometry, state.turns,
               left);
  } else if (steer(workspace.view.camera, left)) {
    workspace.view.cameraMoved = true;
  }
}

void drawTool(const ToolState& state, const Workspace& workspace, const ToolPane& pane) {
  if (const auto draw = toolNow(state, workspace, kindOf(pane)).draw) draw(state, workspace, pane);
}

bool takesDoubleClicks(const Workspace& workspace, PaneKind kind) {
  return firstRow(workspace, kind).doubleClicks;
}

}  // namespace sonoskin::ui
