#include "app/workspace/workspace.h"

#include "app/document/face_view.h"
#include "app/texts/texts.h"
#include "app/workspace/view_file.h"
#include "core/io/scanners/raw_file.h"

namespace sonoskin {

void Workspace::confirmLoss(const std::string& what, std::function<void()> action) {
  if (isModified())
    question = {what, std::move(action)};
  else
    action();
}

bool Workspace::isModified() const { return session.hasUnsavedWork() || !(marksKey(view) == savedMarks); }

bool Workspace::isAsked() const {
  return question || choice || rawQuestion || lostVolume || recovery || pictureRequest || !dropped.empty();
}

void Workspace::dropQuestions() {
  question.reset();
  choice.reset();
  rawQuestion.reset();
  pictureRequest.reset();
  lostVolume.reset();
  dropped.clear();
  recovery.reset();
}

void Workspace::keepSettings() const { writeSettings(settingsFile(), settings); }

void Workspace::open(const std::filesystem::path& file) {
  confirmLoss(tr("Opening another scan"), [this, file] { askOrOpen(file); });
}

// A file without a header is opened once the person has said what it holds; what was said last, or its size, proposes. What the
// program was started with, or what was said of one file, counts for no other.
void Workspace::askOrOpen(const std::filesystem::path& file) {
  std::error_code code;
  const bool isFile = std::filesystem::is_regular_file(file, code);
  const RawOptions told = session.hasScan() ? RawOptions() : session.parameters().raw;
  if (!isFile || !needsRawOptions(file, told)) {
    Parameters parameters = session.parameters();
    parameters.raw = told;
    session.edit(parameters);
    return session.openFile(file);
  }
  RawQuestion asked{file, session.parameters().raw, std::filesystem::file_size(file, code)};
  const std::vector<RawGuess> guesses = guessRaw(asked.bytes);
  if (!isTold(asked.options) && !guesses.empty()) {
    asked.options.dims = guesses.front().dims;
    asked.options.type = guesses.front().type;
  }
  rawQuestion = asked;
}

void Workspace::openRaw() {
  Parameters parameters = session.parameters();
  parameters.raw = rawQuestion->options;
  session.edit(parameters);
  session.openFile(rawQuestion->file);
  rawQuestion.reset();
}

ViewFrame Workspace::viewFrame() const {
  return viewFrameOf(session.scan(), session.beam(), view.orientation);
}

void Workspace::lookAtFace() {
  const Results& results = session.results();
  const ViewFrame frame = viewFrame();
  resetCamera(view, frame, surroundings(session.scan(), results));
  constexpr float kAspect = 1.2f;  // as resetCamera has it
  const Beam beam{.apex = {}, .axis = frame.turned(frame.forward), .up = frame.turned(frame.up)};
  if (const FaceFit* face = session.face(); face && results.mesh && !results.mesh->positions.empty())
    view.camera = cameraOnFace(results.mesh->positions, face, beam, kAspect);
}

}  // namespace sonoskin
