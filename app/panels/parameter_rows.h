#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"
#include "app/workspace/workspace.h"

namespace sonoskin::ui {

// What the panels of parameters share.

// applyEdit: hands edited parameters to the session, and makes the step for undo where they were let go.
void applyEdit(Workspace& workspace, const Parameters& parameters, FieldsEdit edit);

// sentence: with a capital letter.
std::string sentence(std::string_view text);

// useOf: greys the parameters of a group that have no effect beside the others' values, and says why.
//   parameters  must live as long as the rows are drawn
std::function<RowText(std::string_view field)> useOf(const Parameters& parameters, std::string_view group);

// groupRows: the rows of a group, or some of them, below a heading.
template <class Options>
FieldsEdit groupRows(const char* title, std::string_view group, Options& options, const Rows& rows) {
  FieldsEdit edit;
  heading(title);
  if (!beginFields(std::string(group).c_str())) return edit;
  edit = editFields(group, options, rows);
  endFields();
  return edit;
}

}  // namespace sonoskin::ui
