#pragma once

#include <optional>

#include "app/panels/export_plan.h"

namespace sonoskin::ui {

// ExportDialog: what is written, as what, where, which files that gives and which of them are there already, and the command
// that repeats it.
class ExportDialog {
 public:
  // draw: while Workspace::exportShown; gives the choice in the frame in which it is made. What is there already is asked about
  // before.
  std::optional<FileChoice> draw(Workspace& workspace);
  // takes: whether the file dialog answers this one, which has its choice then.
  bool takes(const FileChoice& choice);

 private:
  void begin(const Workspace& workspace);
  void drawItems(const Workspace& workspace);
  void drawPlace(Workspace& workspace);
  void drawFormat();
  void drawPlacement();
  void drawFiles(const Workspace& workspace) const;
  void drawCommand(const Workspace& workspace) const;
  bool drawButtons(Workspace& workspace);
  void changed() { replaceAsked_ = false; }

  std::optional<ExportPlan> plan_;
  bool shown_ = false, browsing_ = false, replaceAsked_ = false;
};

}  // namespace sonoskin::ui
