#pragma once

#include <string>

#include "app/widgets/fields_ui.h"
#include "core/pipeline/parameters.h"

namespace sonoskin::ui {

// presetRow: a row that shows which preset the parameters are, and applies another when it is chosen. Between
// beginFields() and endFields().
FieldsEdit presetRow(Parameters& parameters);

// presetTitle: a preset's name for people: "thesis-baby-1" -> "Thesis baby 1".
std::string presetTitle(std::string_view name);

}  // namespace sonoskin::ui
