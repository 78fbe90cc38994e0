#pragma once

#include <string>

#include "app/widgets/fields_ui.h"

namespace sonoskin::ui {

// What the rows of all types share. A row is: label and symbol; the widget, over widgetWidth(); at the right the button that
// brings the default back, whose place stays where there is nothing to bring back.

// openRow: the label and the identity of the row; the widget comes next.
void openRow(const FieldRow& row);
float widgetWidth();

// afterWidget: names the last item for tests and gives it its tooltip.
//   facts   a line of it: range and default
//   output  whether a double click or the right button asked for the default
bool afterWidget(const FieldRow& row, const std::string& facts);

// closeRow: the button of the default.
//   output  whether it was pressed
bool closeRow(const FieldRow& row, bool differs);

// finish: both, for a row of one widget; sets the default where it was asked for.
template <class T>
FieldsEdit finish(const FieldRow& row, T& value, const T& standard, const std::string& facts) {
  const bool asked = afterWidget(row, facts);
  if (!(closeRow(row, value != standard) || asked) || value == standard) return {};
  value = standard;
  return {true, true};
}

std::string withUnit(const std::string& number, const Field& field);
std::string rangeText(const std::string& from, const std::string& to, const std::string& standard);

}  // namespace sonoskin::ui
