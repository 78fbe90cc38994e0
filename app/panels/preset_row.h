#pragma once

#include <string>

#include "app/widgets/fields_ui.h"
#include "app/workspace/workspace.h"
#include "core/pipeline/parameters.h"

namespace sonoskin::ui {

// presetRow: a row that shows which preset the parameters are, the program's or the person's own, and applies another when it
// is chosen; the parameters can be kept as one there, too. Between beginFields() and endFields().
FieldsEdit presetRow(Workspace& workspace, Parameters& parameters);

// drawPresetName: asks for the name of a preset that is to be kept.
void drawPresetName(Workspace& workspace);

}  // namespace sonoskin::ui
