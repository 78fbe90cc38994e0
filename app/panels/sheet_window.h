#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/document/worker.h"
#include "app/panels/sheet_plan.h"
#include "render/gl/texture.h"

namespace sonoskin::ui {

// SheetWindow: the dialog of the contact sheet: what it goes over and shows, the sheet as it is made in the background, and the
// sheet itself, where a click on a picture takes its values over.
class SheetWindow {
 public:
  // ContextFor: an OpenGL context for the background; called where work begins.
  using ContextFor = std::function<std::shared_ptr<gl::Context>()>;

  // draw: while Workspace::sheetShown, and takes in what was made. Call it in every frame.
  //   output  seconds until it wants the next frame; negative: none
  double draw(Workspace& workspace, const ContextFor& contextFor);
  // save: the sheet that is shown, which there must be, as a picture with the recipe beside it.
  void save(Workspace& workspace, const std::filesystem::path& path) const;
  bool busy() const { return worker_.status().busy; }
  const std::optional<ContactSheet>& sheet() const { return sheet_; }

 private:
  void drawPlan(Workspace& workspace);
  void drawAxis(std::size_t axis, const std::vector<SheetNumber>& numbers);
  void drawPicture(Workspace& workspace);
  void drawButtons(Workspace& workspace, const ContextFor& contextFor);
  void make(Workspace& workspace, const ContextFor& contextFor);
  void upload(float scale);
  void drawSheet(Workspace& workspace);
  void drawCells(Workspace& workspace, glm::vec2 corner, float scale);
  void take(Workspace& workspace, std::size_t cell);

  Worker worker_;
  std::optional<SheetPlan> plan_;
  std::optional<ContactSheet> sheet_;
  std::vector<SheetAxis> axes_;  // of the sheet
  std::string command_;          // that makes it
  Image image_;                  // of the sheet
  gl::Texture texture_;          // of the sheet or, halved so often, as fine as it is shown
  int halvings_ = 0;
  bool stale_ = true;
  std::uint64_t opened_ = 0;  // of which scan it is
  std::string complaint_;
};

}  // namespace sonoskin::ui
