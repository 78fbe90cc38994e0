#include "app/workspace/session_actions.h"

#include <fmt/format.h>

#include <utility>

#include "app/document/input.h"
#include "app/texts/texts.h"
#include "app/workspace/cursor_steps.h"
#include "app/workspace/view_file.h"
#include "app/workspace/view_history.h"
#include "app/workspace/workspace.h"
#include "core/io/file_formats.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

void openSession(Workspace& w, const fs::path& path) {
  w.confirmLoss(tr("Opening a session"), [&w, path] { w.session.openSession(path); });
}

void tellMesh(Workspace& w, const fs::path& path) {
  const std::string sentence =
      trf("{} is a surface; the window opens volumes and makes surfaces of them. A picture of it "
          "is made by 'sonoskin render'.",
          path.filename().string());
  w.toasts.add(sentence, true);
}

}  // namespace

void saveSession(Workspace& w, std::function<void()> then) {
  if (w.sessionFile.empty()) return askWhereToSave(w, std::move(then));
  w.afterSaving = std::move(then);
  saveSessionTo(w, w.sessionFile);
}

void askWhereToSave(Workspace& w, std::function<void()> then) {
  w.afterSaving = std::move(then);
  w.files.ask(ui::FilePurpose::saveSession, w.settings.folder, "face.sonoskin");
}

void saveSessionTo(Workspace& w, const fs::path& path) {
  const auto saved = [&w, path, marks = marksKey(w.view), then = std::exchange(w.afterSaving, {})] {
    w.sessionFile = path;
    w.savedMarks = marks;
    w.settings.noteOpened(path);
    w.keepSettings();
    if (then) then();
  };
  w.session.saveSession(path, writeViews(w.view), saved);
}

void openRecipe(Workspace& w, const fs::path& path) {
  w.confirmLoss(tr("Opening a recipe"), [&w, path] { w.session.loadRecipe(path); });
}

void takeDropped(Workspace& w, const std::vector<fs::path>& files) {
  if (files.size() == 1) openAny(w, files.front());
  if (files.size() > 1) w.dropped = files;
}

void openAny(Workspace& w, const fs::path& path) {
  w.toasts.log.hide(path);
  if (formatNamed(FileKind::session, path)) return openSession(w, path);
  if (formatNamed(FileKind::recipe, path)) return openRecipe(w, path);
  if (isMeshFile(path.string())) return tellMesh(w, path);
  w.open(path);
}

void openFound(Workspace& w, const fs::path& volume) {
  if (const auto lost = std::exchange(w.lostVolume, {})) w.session.openSession(*lost, volume);
}

void takeInOpened(Workspace& w) {
  Session& session = w.session;
  if (auto lost = session.takeLostVolume()) w.lostVolume = std::move(lost);
  if (w.noted != session.opened()) {
    w.noted = session.opened();
    beginViewEdits(w);
    w.sessionFile.clear();
    w.savedMarks = marksKey(w.view);
    if (!session.source().empty()) w.settings.noteOpened(session.source());
    w.keepSettings();
  }
  const auto reopened = session.takeReopened();
  if (!reopened) return;
  readViews(reopened->file.views, w.view);
  if (session.hasScan()) w.view.cursor = inVolume(session.scan().volume->geometry, w.view.cursor);
  beginViewEdits(w);
  w.view.cameraMoved = true;  // it stays where it was when points and surface are made again
  w.restored |= reopened->recovers;
  if (reopened->recovers) return;
  w.savedMarks = marksKey(w.view);
  w.sessionFile = reopened->path;
  w.settings.noteOpened(reopened->path);
  w.keepSettings();
}

}  // namespace sonoskin
