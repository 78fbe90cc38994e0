#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/panels/export_dialog.h"
#include "app/panels/sheet_window.h"
#include "app/panels/tour.h"
#include "app/views/four_up.h"
#include "app/widgets/open_lists.h"
#include "app/window/event_queue.h"
#include "app/window/menu_keys.h"
#include "app/window/widget_keys.h"
#include "app/workspace/autosave.h"
#include "app/workspace/objects_seen.h"
#include "app/workspace/workspace.h"
#include "core/base/log.h"
#include "core/base/timer.h"
#include "core/pipeline/parameters.h"
#include "render/gl/context.h"

namespace sonoskin {

// Application: all that is in the window, and what follows from what a person does there: it takes events, and draws with the
// OpenGL context and in the frame of Dear ImGui that are current. Whether there is a window is nothing to it (WindowLoop has one).
// An error in a frame is shown in it and does not end it.
class Application {
 public:
  // Around: where it is drawn.
  //   settings   as they were remembered
  //   apart      an OpenGL context for work behind the window, which leaves no GL objects; called on the frame's thread
  struct Around {
    Settings settings;
    std::function<std::shared_ptr<gl::Context>()> apart;
  };
  // The context must be current, and outlive it.
  Application(const std::optional<std::filesystem::path>& file, const Parameters& parameters, Around around);
  ~Application();  // remembers the settings

  // secondsToNext: to the next frame where nothing happens; infinite: none is wanted.
  double secondsToNext() const;
  // waitSeconds: how long to wait for something to happen before takeIn() is called again.
  double waitSeconds() const;
  // takeIn: what the background has made; whether there is something new to be seen.
  bool takeIn();
  // beforeFrame: before that of the interface begins: how keys steer it.
  ui::KeySteering beforeFrame();
  // FrameInput: what a frame gets.
  //   dropped      files, on the window
  //   catchesUp    more events wait: it is not seen
  //   screenScale  of texts and widgets, as the screen has it
  struct FrameInput {
    std::optional<Event> event{};
    std::vector<std::filesystem::path> dropped{};
    bool catchesUp = false;
    double screenScale = 1;
  };
  // FrameWish: what it asks for.
  //   settle  what has opened, or is gone to, is to be ready for keys before the next event
  //   frames  that are to follow at once
  struct FrameWish {
    bool settle = false;
    int frames = 0;
  };
  // frame: between the beginning of the interface's frame and its end.
  FrameWish frame(const FrameInput& input);
  // afterFrame: once it is drawn.
  void afterFrame();
  // keep: the session, in case of a crash, where it is time.
  void keep();
  // attempt: an error is shown in the window; whether there was none.
  bool attempt(const std::function<void()>& action);
  void askToQuit();
  // goesOn: false once it was quit and all is saved.
  bool goesOn() const { return !workspace_.quit || workspace_.session.saving(); }

  Workspace& workspace() { return workspace_; }
  const Workspace& workspace() const { return workspace_; }
  Autosave& autosave() { return autosave_; }

 private:
  void takeInput(const FrameInput& input);
  void updateDocument();
  void drawInterface();
  void askToRestore();
  void lookForGlErrors();
  ui::ToastPlace drawMain();  // where messages may lie
  void act(const ui::FileChoice& choice);
  void saveMessages(const std::filesystem::path& path);
  void saveSkin(const std::filesystem::path& path, bool light);
  void savePicture(const std::filesystem::path& path);
  void saveTurntable(const std::filesystem::path& path);
  void saveReport(const std::filesystem::path& path);

  LogRecord log_;  // what is said anywhere, until updateDocument shows it
  std::function<std::shared_ptr<gl::Context>()> apart_;
  Workspace workspace_;
  MenuKeys menuKeys_;
  Autosave autosave_{stateFolder()};
  WidgetKeys widgetKeys_;
  ui::FourUp views_;
  ui::TourWindow tour_;
  ui::SheetWindow sheet_;
  ui::ExportDialog export_;
  ObjectsSeen<1> shownPoints_;  // what the views were last reset for
  std::uint64_t opened_ = 0;
  std::set<std::string> noted_;        // of this document: each of its time steps may say the same
  std::uint64_t reconstructions_ = 0;  // seen so far
  double viewsWant_ = -1, toastsWant_ = -1, playWants_ = -1, sheetWants_ = -1;  // seconds after a frame
  Timer frame_, sinceDrawn_;  // since it began, and was over
  bool glErrorTold_ = false;
};

}  // namespace sonoskin
