#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>

#include "app/session.h"
#include "app/settings.h"
#include "app/view_state.h"
#include "app/widgets/file_dialog.h"
#include "app/widgets/toasts.h"

namespace sonoskin {

// Workspace: everything that menus, keys and panels act on.
struct Workspace {
  explicit Workspace(const Parameters& parameters) : session(parameters) {}

  // open: a volume file, remembered as a recent one.
  void open(const std::filesystem::path& file) {
    settings.noteOpened(file);
    session.openFile(file);
  }

  // lookAtStart: at the face where it is known, else from the probe.
  void lookAtStart();

  Session session;
  ViewState view;
  Settings settings;
  ui::FileDialog files;
  ui::Toasts toasts;
  bool keysShown = false, aboutShown = false;
  glm::dvec3 typedSpacing{1};  // mm; for files that give none
  std::string glInfo;          // the driver's words
  bool quit = false;
};

}  // namespace sonoskin
