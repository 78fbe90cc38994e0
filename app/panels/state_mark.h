#pragma once

#include <imgui.h>

#include "app/workspace/stages.h"

namespace sonoskin::ui {

// colourOf: the colour of a state's words. drawStateMark: its mark around a place on the screen; every state has a form of its
// own, so that no colour need be told.
ImVec4 colourOf(StageState state);
void drawStateMark(StageState state, ImVec2 middle);

}  // namespace sonoskin::ui
