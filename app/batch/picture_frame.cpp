#include "app/batch/picture_frame.h"

#include "app/document/face_view.h"

namespace sonoskin {

PictureOptions pictureFrame(const Mesh& mesh, const FaceFit* face, const Beam& beam, glm::ivec2 size,
                            bool turnsFormat) {
  PictureOptions frame;
  frame.size = size;
  frame.beam = beam;
  if (turnsFormat && isTall(mesh.positions, face, beam)) frame.size = {size.y, size.x};
  frame.camera = "face";
  frame.face = cameraOnFace(mesh.positions, face, beam, float(frame.size.x) / float(frame.size.y));
  return frame;
}

}  // namespace sonoskin
