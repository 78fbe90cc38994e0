#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>

#include "app/panels/sheet_window.h"
#include "app/panels/tour.h"
#include "app/views/four_up.h"
#include "app/window/background_context.h"
#include "app/window/desktop_window.h"
#include "app/window/menu_keys.h"
#include "app/window/widget_keys.h"
#include "app/workspace/autosave.h"
#include "app/workspace/objects_seen.h"
#include "app/workspace/workspace.h"
#include "core/base/log.h"
#include "core/base/timer.h"
#include "core/pipeline/parameters.h"

namespace sonoskin {

// Application: the window with all that is in it. frame() is one turn of its loop. An error in a frame is
// shown in the window and does not end it.
class Application {
 public:
  Application(const std::optional<std::filesystem::path>& file, const Parameters& parameters);
  ~Application();  // remembers the settings

  // frame: waits for something to do, does it, draws; false when the window was closed and all is saved.
  bool frame();

  // For tests: the document and the views, and a frame even though nothing happened.
  Workspace& workspace() { return workspace_; }
  const Workspace& workspace() const { return workspace_; }
  Autosave& autosave() { return autosave_; }
  void requestFrame() { window_.requestFrames(1); }
  bool eventsWait() const { return window_.eventsWait(); }
  // atFrame: called where a frame begins that will be shown.
  std::function<void()> atFrame;

 private:
  void takeInput(const std::optional<Event>& event);
  void updateDocument();
  void draw();
  void drawInterface();
  void answerClosing();
  void askToRestore();
  void showModified();
  void lookForGlErrors();
  ui::ToastPlace drawMain();  // where messages may lie
  void act(const ui::FileChoice& choice);
  void saveMessages(const std::filesystem::path& path);
  void saveSkin(const std::filesystem::path& path, bool light);
  void savePicture(const std::filesystem::path& path);
  void saveTurntable(const std::filesystem::path& path);
  BackgroundContext& background();
  bool attempt(const std::function<void()>& action);  // whether it ended well
  double secondsToNext() const;                       // frame, where nothing happens

  LogRecord log_;  // what is said anywhere, until updateDocument shows it
  Settings settings_;
  DesktopWindow window_;
  std::optional<BackgroundContext> background_;  // made when first needed
  Workspace workspace_;
  MenuKeys menuKeys_;
  Autosave autosave_{stateFolder()};
  WidgetKeys widgetKeys_;
  ui::FourUp views_;
  ui::TourWindow tour_;
  ui::SheetWindow sheet_;
  ObjectsSeen<1> shownPoints_;  // what the views were last reset for
  std::uint64_t opened_ = 0;
  std::set<std::string> noted_;        // of this document: each of its time steps may say the same
  std::uint64_t reconstructions_ = 0;  // seen so far
  double viewsWant_ = -1, toastsWant_ = -1, playWants_ = -1, sheetWants_ = -1;  // seconds after a frame
  Timer sinceDrawn_;
  bool glErrorTold_ = false, titleModified_ = false;
};

}  // namespace sonoskin
