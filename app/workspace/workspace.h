#pragma once

#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "app/document/session.h"
#include "app/widgets/file_dialog.h"
#include "app/widgets/toasts.h"
#include "app/workspace/commands.h"
#include "app/workspace/settings.h"
#include "app/workspace/step.h"
#include "app/workspace/time_left.h"
#include "app/workspace/time_play.h"
#include "app/workspace/view_state.h"

namespace sonoskin {

// Workspace: everything that menus, keys and panels act on.
struct Workspace {
  explicit Workspace(const Parameters& parameters) : session(parameters) {}

  // Question: what a person is asked before it is done, for it would lose unsaved work.
  struct Question {
    std::string what;  // "Opening another scan"
    std::function<void()> action;
  };
  // RawQuestion: a file without a header, and what the person says of it.
  struct RawQuestion {
    std::filesystem::path file;
    RawOptions options;
    std::uintmax_t bytes = 0;  // of the file
  };
  // confirmLoss: does something that ends the document, after a question where work would be lost.
  void confirmLoss(const std::string& what, std::function<void()> action);
  // open: a volume file, remembered as a recent one.
  void open(const std::filesystem::path& file);
  void askOrOpen(const std::filesystem::path& file);
  // openRaw: the file of rawQuestion, as it says.
  void openRaw();

  // viewFrame: that of the scan, which there must be, as the person has it.
  ViewFrame viewFrame() const;
  // lookAtFace: at the face where it is known, else from the probe or from before the patient.
  void lookAtFace();

  Session session;
  ViewState view;
  Settings settings;
  ui::FileDialog files;
  ui::Toasts toasts;
  std::optional<Question> question;
  std::optional<VolumeChoice> choice;      // of several volumes in a file, which the person is asked to make
  std::optional<RawQuestion> rawQuestion;  // what a file without a header holds
  Step step = Step::volume;                // whose parameters are shown
  TimeLeft timeLeft;
  TimePlay play;
  bool keysShown = false, aboutShown = false;
  std::optional<Menu> menuAsked;  // by a key, to be opened
  double screenScale = 1;         // of texts and widgets, where the settings have none
  glm::dvec3 typedSpacing{1};     // mm; for files that give none
  std::string glInfo;             // the driver's words
  bool quit = false;
};

}  // namespace sonoskin
