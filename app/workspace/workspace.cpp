#include "app/workspace/workspace.h"

#include "app/document/face_view.h"

namespace sonoskin {

void Workspace::confirmLoss(const std::string& what, std::function<void()> action) {
  if (session.hasUnsavedWork())
    question = {what, std::move(action)};
  else
    action();
}

void Workspace::open(const std::filesystem::path& file) {
  confirmLoss("Opening another scan", [this, file] {
    settings.noteOpened(file);
    session.openFile(file);
  });
}

void Workspace::lookAtFace() {
  const Results& results = session.results();
  const Beam beam = session.beam();
  resetCamera(view, beam, surroundings(session.scan(), results));
  constexpr float kAspect = 1.2f;  // as resetCamera has it
  if (const FaceFit* face = session.face(); face && results.mesh && !results.mesh->positions.empty())
    view.camera = cameraOnFace(results.mesh->positions, face, beam, kAspect);
}

}  // namespace sonoskin
