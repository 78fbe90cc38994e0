#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/document/worker.h"
#include "app/views/light_refiner.h"
#include "app/workspace/skin_quality.h"
#include "app/workspace/workspace.h"
#include "core/skin/skin_surface.h"
#include "render/skin/skin_view.h"

namespace sonoskin::ui {

// SkinShot: all that a picture of skin depends on, but the camera.
//   kept        the settings on the left of the divider where they are compared
struct SkinShot {
  std::shared_ptr<const SkinSurface> surface;
  SkinSettings settings, kept;
  HomeFrame home;
  SkinQuality quality;
  SkinPass pass = SkinPass::skin;
  SkinCompare compare = SkinCompare::off;
  float divider = 0.5f, unseenShade = 0;
  bool background = true;
  ClipPlane clip{};
};

// SkinPictureOptions: see SkinViewInput.
struct SkinPictureOptions {
  int supersampling = 1, steps = 1000;
};

// SkinViews: keep the light of the present settings and of those that they are compared with; each is made when first
// needed.
struct SkinViews {
  std::optional<SkinView> present, kept;
};

// drawSkin: a picture of skin, of two settings side by side where they are compared.
//   input  gpu   holds the shot's surface
void drawSkin(const SkinShot& shot, const Camera& camera, const GpuSkin& gpu, SkinViews& views,
              const SkinPictureOptions& options, const gl::Target& target);

// lookOf: the settings as the renderer takes them.
SkinLook lookOf(const SkinSettings& settings, const HomeFrame& home, const Box& box);

// SkinScene: the skin look of the 3D view. The shown mesh is prepared in the background; until that is done the view
// shows it plainly lit.
class SkinScene {
 public:
  // update: once a frame while skin is to be shown; begins to prepare the session's mesh where it is another one, or
  // another quality is wanted.
  //   output  sentences about what failed
  std::vector<std::string> update(Workspace& workspace);
  // shows: whether the session's mesh can be shown as skin.
  bool shows(const Workspace& workspace) const;
  // caption: "Preparing skin  40 %", "Refining light  40 %", or empty.
  std::string caption() const;
  // letGo: gives back all that was made for a mesh that is gone; for a document that was closed.
  void letGo();
  bool preparing() const { return worker_ && worker_->status().busy; }

  // addTo: everything but camera and size that a picture depends on.
  void addTo(Hasher& hasher, const Workspace& workspace) const;

  // draw: one picture; the light follows in steps over several draws where it takes long.
  void draw(const Workspace& workspace, int supersampling, const gl::Target& target);
  // shot: what is shown; once there is something to show.
  SkinShot shot(const Workspace& workspace) const;
  // light: of the last picture; of two, of that which is behind.
  LightState light() const { return light_; }
  // refine: once a frame: light that rests is spread from point to point in the background. What has come of it counts in
  // addTo.
  //   output  sentences about what failed
  std::vector<std::string> refine(const Workspace& workspace, bool rests);
  bool refining() const { return presentRefiner_.status().busy || keptRefiner_.status().busy; }
  // note: after a draw of a whole view: how long such pictures take.
  void note(Workspace& workspace, double share);

 private:
  struct Wanted {
    std::shared_ptr<const Mesh> mesh;
    bool full = false;
    friend bool operator==(const Wanted&, const Wanted&) = default;
  };
  void prepare(const Wanted& wanted, const Workspace& workspace);
  void refine(SkinView& view, LightRefiner& refiner, const SkinSettings& settings, bool rests);
  LightState lightOfViews() const;
  SkinQuality quality() const { return shown_.full ? fullQuality() : lightQuality(); }

  std::unique_ptr<Worker> worker_;
  Wanted wanted_, shown_;
  std::shared_ptr<const SkinSurface> prepared_;
  int preparations_ = 0;  // its number: addresses come back
  std::optional<GpuSkin> surface_;
  SkinViews views_;
  LightRefiner presentRefiner_, keptRefiner_;
  int refined_ = 0;        // times that a light was refined
  bool compared_ = false;  // whether the last picture showed both
  QualityChooser chooser_;
  std::optional<SkinTimes> times_;           // of what is prepared
  LightState light_ = LightState::complete;  // nothing is on its way yet
  int drawn_ = 0;                            // pictures of what is prepared
};

// homeOf: the frame in which the angles of the session's light count: that of the view from the probe.
HomeFrame homeOf(const Workspace& workspace);

}  // namespace sonoskin::ui
