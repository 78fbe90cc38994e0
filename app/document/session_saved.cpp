// What the session knows of what is saved.
#include "app/document/session.h"
#include "core/pipeline/stage_keys.h"

namespace sonoskin {

Session::SavedState Session::presentState() const {
  return {contentKey(document_.parameters), document_.erased.key(),
          frame_.results.mesh ? frame_.made.key() : Key()};
}

Key Session::workKey() const {
  const SavedState now = presentState();
  return Hasher("work")
      .add(frame_.scan.key)
      .add(parametersKey(recipeParameters(document_)))
      .add(now.erased)
      .add(now.mesh)
      .add(follows_)
      .key();
}

// A surface that was made with short cuts on the way is no more than the final one of the same parameters.
bool Session::hasUnsavedWork() const {
  if (!hasScan()) return false;
  const SavedState now = presentState();
  MeshOrigin final = frame_.made;
  final.isFinal = true;
  const bool surfaceSaved = now.mesh == saved_.mesh || final.key() == saved_.mesh;
  return !(now.content == saved_.content) || !(now.erased == saved_.erased) ||
         (frame_.results.mesh && !surfaceSaved);
}

// The recipe beside a surface has parameters; where the surface is that of the document, they are its own.
std::function<void()> Session::savedMesh(const Parameters& written) {
  SavedState then = presentState();
  then.content = contentKey(written);
  return [this, then, isCurrent = meshIsCurrent()] {
    saved_.mesh = then.mesh;
    if (!isCurrent) return;
    saved_.content = then.content;
    saved_.erased = then.erased;
  };
}

}  // namespace sonoskin
