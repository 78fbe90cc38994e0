#pragma once

namespace sonoskin {

struct Workspace;

// Marks, clip plane and colours are in the views while a person changes them, and in the document's history.

// noteViewEdits: once a frame: what has been changed becomes a step for undo, and what undo and redo brought is shown.
//   held  the mouse or a widget holds something: all of a drag is one step
void noteViewEdits(Workspace& workspace, bool held);

// beginViewEdits: what the views of another document begin with is no step.
void beginViewEdits(Workspace& workspace);

}  // namespace sonoskin
