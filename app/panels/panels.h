#pragma once

#include "app/workspace/workspace.h"

namespace sonoskin::ui {

// The parts of the window around the views: free functions that draw into the current ImGui window, or into
// one of their own where it says so, and act on the workspace.

void drawMenuBar(Workspace& workspace);

// The side panel, from top to bottom.
void drawVolumePanel(Workspace& workspace);
void drawRegionPanel(Workspace& workspace);  // eraser and crop box
void drawLassoRows(Workspace& workspace);    // while it is chosen
void drawClassificationPanel(
    Workspace& workspace);  // preset, the first parameters, the others under "Advanced"
void drawReconstructionPanel(
    Workspace& workspace);  // smoothness, fit and mesh and print under "Advanced", the button, what was made
void drawViewPanel(Workspace& workspace);
void drawProfilePanel(Workspace& workspace);  // how far light goes below the skin; part of the skin panel
void drawSkinPanel(
    Workspace& workspace);  // where the 3D view shows skin: its look, the light, what is compared
void drawMorePanel(Workspace& workspace);  // the parameters of the other stages, a heading each

// The line at the bottom: dimensions, spacing, cross-hair, points, triangles, area, time; at its right what opens the log.
void drawStatusBar(Workspace& workspace);

// Windows of their own.
void drawKeys(Workspace& workspace);
void drawAbout(Workspace& workspace);
void drawQuestion(Workspace& workspace);      // before unsaved work is lost
void drawRawQuestion(Workspace& workspace);   // what a file without a header holds
void drawVolumeChoice(Workspace& workspace);  // which of several volumes in a file is opened
float drawLog(Workspace& workspace);  // all messages, at the lower right; its height, 0 while it is closed

}  // namespace sonoskin::ui
