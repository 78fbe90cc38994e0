#pragma once

#include "app/views/tools.h"

namespace sonoskin::ui {

enum class PaneKind { slice, space };

// toolIn: the tool that gets the left button when it goes down in a view of a kind: the first of kTools that can do
// something there.
Tool toolIn(const Workspace& workspace, PaneKind kind);

// useTool: what the mouse does in a view in this frame. The tool that holds it keeps it until the button goes up or the
// tool is put away; else toolIn has it first, and those after it where that one was not chosen and leaves it. What they
// leave steers: cross-hair, slice and grey window, or the camera.
void useTool(ToolState& state, Workspace& workspace, const ToolPane& pane);

// drawTool: the marks of the tool that has the mouse.
void drawTool(const ToolState& state, const Workspace& workspace, const ToolPane& pane);

// takesDoubleClicks: whether two quick clicks are the tool's, one after the other, and no wish to see the view alone.
bool takesDoubleClicks(const Workspace& workspace, PaneKind kind);

}  // namespace sonoskin::ui
