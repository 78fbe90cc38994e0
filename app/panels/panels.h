#pragma once

#include <imgui.h>

#include <span>

#include "app/workspace/shown_pane.h"
#include "app/workspace/workspace.h"

namespace sonoskin::ui {

// The parts of the window around the views: free functions that draw into the current ImGui window, or into
// one of their own where it says so, and act on the workspace.

void drawMenuBar(Workspace& workspace);

// The side panel: the list of steps, the parameters of the chosen one, which alone scroll, and the work that goes on.
//   output  where toasts may lie: above the work, over the parameters
ToastPlace drawSidePanel(Workspace& workspace, ImVec2 size);
float sidePanelWidth();

// Its parts. The list of steps tells the state of each; a click opens it.
void drawStepList(Workspace& workspace);
void drawWork(Workspace& workspace);  // the button that reconstructs, what goes on and how to end it
float workHeight();                   // of that, which is always the same

// The parameters of the steps.
void drawVolumePanel(Workspace& workspace);
void drawRegionPanel(Workspace& workspace);  // eraser and crop box
void drawLassoRows(Workspace& workspace);
void drawClassificationPanel(Workspace& workspace);
void drawReconstructionPanel(Workspace& workspace);
void drawSkinPanel(Workspace& workspace);     // the skin's look, the light, what is compared
void drawProfilePanel(Workspace& workspace);  // how far light goes below the skin; part of it
void drawExportPanel(Workspace& workspace);

// The bars over the views: what each of them shows.
//   places  of the views, on the screen
void drawViewBars(Workspace& workspace, std::span<const ShownPane> places);

// The line at the bottom: dimensions, spacing, cross-hair, points, triangles, area, time; at its right what opens the log.
void drawStatusBar(Workspace& workspace);

// Windows of their own.
void drawKeys(Workspace& workspace);
void drawHistory(Workspace& workspace);  // the steps that can be taken back
void drawAbout(Workspace& workspace);
void drawQuestion(Workspace& workspace);         // before unsaved work is lost
void drawLostVolume(Workspace& workspace);       // where a session's volume is
void drawDropped(Workspace& workspace);          // which of several files is opened
void drawRecovery(Workspace& workspace);         // whether to restore what was open when the program ended
void drawRawQuestion(Workspace& workspace);      // what a file without a header holds
void drawVolumeChoice(Workspace& workspace);     // which of several volumes in a file is opened
void drawLog(Workspace& workspace);              // all messages, at the lower right
void drawPictureQuestion(Workspace& workspace);  // the format of pictures to be saved
void drawColoursWindow(Workspace& workspace);    // the transfer function of a translucent volume

}  // namespace sonoskin::ui
