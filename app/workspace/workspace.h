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
#include "app/workspace/help_state.h"
#include "app/workspace/picture_request.h"
#include "app/workspace/settings.h"
#include "app/workspace/shown_volume.h"
#include "app/workspace/step.h"
#include "app/workspace/time_left.h"
#include "app/workspace/time_play.h"
#include "app/workspace/user_presets.h"
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
  // Recovery: what another run of the program left that ended unexpectedly.
  //   told  when it was written, and of what
  struct Recovery {
    std::string told;
    std::function<void()> restore, discard;  // neither: it is asked again at the next start
  };
  // RawQuestion: a file without a header, and what the person says of it.
  struct RawQuestion {
    std::filesystem::path file;
    RawOptions options;
    std::uintmax_t bytes = 0;  // of the file
  };
  // confirmLoss: does something that ends the document, after a question where work would be lost.
  void confirmLoss(const std::string& what, std::function<void()> action);
  // isModified: whether work would be lost: the document's, or marks of measures.
  bool isModified() const;
  // isAsked: whether a question waits for the person; dropQuestions: answers it with no, or later.
  bool isAsked() const;
  void dropQuestions();
  // keepSettings: writes them.
  void keepSettings() const;
  // open: a volume file.
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
  std::optional<LostVolume> lostVolume;        // of a session, for which the person is asked
  std::filesystem::path sessionFile;           // where the session was saved or opened last; empty: nowhere
  std::vector<std::filesystem::path> dropped;  // files, of which the person is asked to choose one
  std::optional<Recovery> recovery;
  bool restored = false;              // what such a run left is open
  std::function<void()> afterSaving;  // what waits until the session is saved
  std::uint64_t noted = 0;            // which opened scan is among the recent files
  Key savedMarks;                     // of the measures that were saved last
  ViewEdits notedEdits;               // that views and document had in common last
  TimePlay play;
  VolumeHistogram histogram;
  PictureFormat pictureFormat;
  std::optional<PictureRequest> pictureRequest;
  std::optional<std::vector<UserPreset>> presets;  // the person's own; not read yet
  std::optional<std::string> presetName;           // of one that is about to be kept, while it is typed
  bool keysShown = false, aboutShown = false, historyShown = false;
  bool sheetShown = false, exportShown = false;  // the dialogs of the contact sheet, and of what is exported
  HelpState help;
  std::optional<Menu> menuAsked;  // by a key, to be opened
  double screenScale = 1;         // of texts and widgets, where the settings have none
  glm::dvec3 typedSpacing{1};     // mm; for files that give none
  std::string glInfo;             // the driver's words
  bool quit = false;
};

}  // namespace sonoskin
