#include "app/panels/parameter_rows.h"

#include <cctype>

#include "app/texts/texts.h"
#include "core/pipeline/parameter_use.h"

namespace sonoskin::ui {

// Another axis that is turned over makes another scan, which has no landmarks and nothing erased.
void applyEdit(Workspace& workspace, const Parameters& parameters, FieldsEdit edit) {
  if (parameters.scan.mirror != workspace.session.parameters().scan.mirror && workspace.isModified())
    return workspace.confirmLoss(tr("Turning an axis over"), [&workspace, parameters] {
      workspace.session.edit(parameters);
      workspace.session.commitEdit();
    });
  if (edit.changed) workspace.session.edit(parameters);
  if (edit.finished) workspace.session.commitEdit();
}

std::string sentence(std::string_view text) { return capitalised(text); }

std::function<RowText(std::string_view field)> useOf(const Parameters& parameters, std::string_view group) {
  return [&parameters, group](std::string_view field) {
    return RowText{.unused = tr(unusedBecause(parameters, group, field))};
  };
}

}  // namespace sonoskin::ui
