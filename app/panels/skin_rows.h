#pragma once

#include "app/widgets/fields_ui.h"
#include "app/workspace/workspace.h"

namespace sonoskin::ui {

// The parts of the skin panel that are no plain rows of parameters.

// lookRow: which named look the parameters are, and another when it is chosen. Between beginFields() and endFields().
FieldsEdit lookRow(Parameters& parameters);

// landmarkRows: a heading, and below it for every landmark a button to place it and one to clear it.
FieldsEdit landmarkRows(Parameters& parameters, ViewState& view);

// drawSkinShow: what is shown, what is compared, and how fine.
void drawSkinShow(Workspace& workspace);

// passTitle: what a pass shows, for people.
const char* passTitle(SkinPass pass);

}  // namespace sonoskin::ui
