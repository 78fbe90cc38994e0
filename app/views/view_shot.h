#pragma once

#include <memory>
#include <variant>

#include "app/views/scene.h"
#include "app/views/skin_scene.h"
#include "app/views/space_window.h"
#include "core/io/image.h"
#include "core/io/textured_mesh_writer.h"
#include "render/pictures.h"

namespace sonoskin::ui {

// ViewShot: all that the 3D view shows at a moment. Pictures of it can be drawn with another OpenGL context, on another
// thread, while the view goes on.
struct ViewShot {
  Camera camera;
  std::variant<VolumeScene, MeshScene, SkinShot> shown;
  std::shared_ptr<const Volume<std::uint8_t>> erased;  // none where nothing is
  Key erasedKey;
};

// takeShot: needs a scan. Skin that is still being prepared is shown as the view shows it, plainly.
ViewShot takeShot(SpaceWindow& window, const Workspace& workspace);
// takeSkinShot: of what can be saved with skin.
//   errors  Error: the skin is not ready yet
SkinShot takeSkinShot(const SpaceWindow& window, const Workspace& workspace);

// drawShot: a picture for a file, four samples per pixel and with finished light; the context that is current draws it.
//   options  size, background and turntable count
//   errors   Error (usage): the size; whatever the turntable throws
Image drawShot(const ViewShot& shot, const PictureOptions& options);
// bakeShot: a surface with the skin's maps, for a file; see render/skin/baked_maps.h.
TexturedMesh bakeShot(const SkinShot& shot, bool light);

}  // namespace sonoskin::ui
