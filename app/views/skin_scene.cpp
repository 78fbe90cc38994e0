#include "app/views/skin_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/texts/texts.h"
#include "app/views/scene.h"
#include "core/base/free_memory.h"
#include "core/pipeline/face_use.h"
#include "core/pipeline/parameter_key.h"

namespace sonoskin::ui {
namespace {

// What is drawn is the second picture's time: the first one may have compiled and uploaded things.
constexpr int kSettled = 2;
constexpr double kLightAtOnce = 0.02;  // seconds; what takes longer is spread over several pictures

SkinSettings presentSettings(const Workspace& w) {
  const Parameters& p = w.session.parameters();
  return {p.skin, p.light, landmarksWithFace(p, w.session.results().face.get())};
}

void addSettings(Hasher& hasher, const SkinSettings& settings) {
  addOptions(hasher, settings.skin);
  addOptions(hasher, settings.light);
  addOptions(hasher, settings.landmarks);
}

}  // namespace

SkinLook lookOf(const SkinSettings& settings, const HomeFrame& home, const Box& box) {
  return {settings.skin, settings.landmarks, makeLightRig(settings.light, home, box)};
}

HomeFrame homeOf(const Workspace& workspace) {
  const Beam beam = workspace.session.beam();
  return homeFrame(lookAlong(glm::vec3(beam.axis), glm::vec3(beam.up), {glm::vec3(0), glm::vec3(1)}, 1));
}

void SkinScene::prepare(const Wanted& wanted, const Workspace& workspace) {
  if (!worker_) worker_ = std::make_unique<Worker>();
  wanted_ = wanted;
  // Of another mesh nothing is shown any more, and two would need twice the memory. Of the same one the other quality is.
  if (shown_.mesh != wanted.mesh) {
    prepared_.reset();
    if (surface_) surface_->set(nullptr);
  }
  const auto made = std::make_shared<std::shared_ptr<const SkinSurface>>();
  const glm::vec3 front = homeOf(workspace).back;
  worker_->replace({"Preparing skin",
                    [made, wanted, front](const Progress& progress) {
                      const SkinQuality quality = wanted.full ? fullQuality() : lightQuality();
                      *made = prepareSkin(wanted.mesh, front, quality, progress);
                      returnFreeMemory();
                    },
                    [this, made, wanted] {
                      prepared_ = *made;
                      ++preparations_;
                      shown_ = wanted;
                      times_.reset();
                      drawn_ = 0;
                    }});
}

void SkinScene::letGo() {
  if (!prepared_ && !views_.present) return;
  presentRefiner_.letGo();
  keptRefiner_.letGo();
  prepared_.reset();
  surface_.reset();
  views_ = {};
  wanted_ = shown_ = {};
}

std::vector<std::string> SkinScene::update(Workspace& workspace) {
  const Wanted wanted{workspace.session.results().mesh, chooser_.full(workspace.settings.skinQuality)};
  // While the surface follows a slider it will be another one at once.
  const bool rests = !workspace.session.activity().busy;
  if (wanted.mesh && !(wanted == wanted_) && rests) prepare(wanted, workspace);
  std::vector<std::string> failures;
  if (worker_) failures = worker_->poll();
  workspace.view.skin.status.full = shown_.full;
  return failures;
}

bool SkinScene::shows(const Workspace& workspace) const {
  return prepared_ && shown_.mesh == workspace.session.results().mesh;
}

std::string SkinScene::caption() const {
  for (const Worker::Status& status :
       {worker_ ? worker_->status() : Worker::Status{}, presentRefiner_.status(), keptRefiner_.status()})
    if (status.busy)
      return fmt::format("{}  {:.0f} %", tr(std::string_view(status.label)), 100 * status.fraction);
  return {};
}

void SkinScene::addTo(Hasher& hasher, const Workspace& workspace) const {
  const SkinShow& show = workspace.view.skin;
  hasher.add(preparations_).add(refined_);
  addSettings(hasher, presentSettings(workspace));
  hasher.add(show.pass).add(show.compare).add(show.divider);
  if (show.compare == SkinCompare::settings && show.kept) addSettings(hasher, *show.kept);
}

SkinShot SkinScene::shot(const Workspace& workspace) const {
  const SkinShow& show = workspace.view.skin;
  SkinShot shot;
  shot.surface = prepared_;
  shot.settings = presentSettings(workspace);
  shot.kept = show.kept.value_or(shot.settings);
  shot.home = homeOf(workspace);
  shot.quality = quality();
  shot.pass = show.pass;
  shot.compare = show.compare;
  shot.divider = show.divider;
  shot.unseenShade = workspace.view.unmeasured ? 1 : 0;
  shot.clip = clipOf(workspace);
  return shot;
}

void drawSkin(const SkinShot& shot, const Camera& camera, const GpuSkin& gpu, SkinViews& views,
              const SkinPictureOptions& options, const gl::Target& target) {
  const auto draw = [&](std::optional<SkinView>& view, const SkinSettings& settings, SkinPass pass,
                        glm::vec2 part) {
    if (!view) view.emplace();
    const SkinLook look = lookOf(settings, shot.home, gpu.box());
    SkinViewInput input{.surface = gpu, .camera = camera, .look = look, .quality = shot.quality};
    input.supersampling = options.supersampling;
    input.steps = options.steps;
    input.pass = pass;
    input.shownPart = part;
    input.unseenShade = shot.unseenShade;
    input.background = shot.background;
    input.clip = shot.clip;
    view->draw(input, target);
  };
  const bool split = shot.compare != SkinCompare::off;
  draw(views.present, shot.settings, shot.pass, {split ? shot.divider : 0, 1});
  if (!split) return;
  const glm::vec2 left(0, shot.divider);
  if (shot.compare == SkinCompare::scatter)
    return draw(views.present, shot.settings, SkinPass::undiffused, left);
  draw(views.kept, shot.kept, shot.pass, left);
}

void SkinScene::draw(const Workspace& workspace, int supersampling, const gl::Target& target) {
  if (!surface_) surface_.emplace();
  surface_->set(prepared_);
  const bool smooth = supersampling > 1;
  SkinShot now = shot(workspace);
  now.quality.diffusion = smooth ? DiffusionMethod::points : DiffusionMethod::blurs;
  const bool atOnce = smooth || (times_ && times_->light < kLightAtOnce);
  const SkinPictureOptions options{supersampling, atOnce ? 1000 : 1};
  drawSkin(now, workspace.view.camera, *surface_, views_, options, target);
  compared_ = now.compare == SkinCompare::settings;
  light_ = lightOfViews();
}

LightState SkinScene::lightOfViews() const {
  const LightState present = views_.present->state();
  // Where the present settings' light is there, it is shown whether the other half has any or not.
  return compared_ ? std::min(present, std::max(views_.kept->state(), LightState::earlier)) : present;
}

void SkinScene::refine(SkinView& view, LightRefiner& refiner, const SkinSettings& settings, bool rests) {
  Hasher hasher("refined light");
  hasher.add(preparations_);
  addSettings(hasher, settings);
  refined_ += refiner.update(view, *surface_, hasher.key(), rests) ? 1 : 0;
}

std::vector<std::string> SkinScene::refine(const Workspace& workspace, bool rests) {
  if (!shows(workspace) || light_ < LightState::complete || !views_.present) {
    presentRefiner_.cancel();
    keptRefiner_.cancel();
    return {};
  }
  if (!compared_) keptRefiner_.cancel();
  const SkinSettings present = presentSettings(workspace);
  refine(*views_.present, presentRefiner_, present, rests);
  if (compared_) refine(*views_.kept, keptRefiner_, workspace.view.skin.kept.value_or(present), rests);
  light_ = lightOfViews();
  std::vector<std::string> failures = presentRefiner_.failures();
  std::ranges::move(keptRefiner_.failures(), std::back_inserter(failures));
  return failures;
}

void SkinScene::note(Workspace& workspace, double share) {
  if (!views_.present || light_ < LightState::complete || ++drawn_ < kSettled ||
      workspace.view.skin.compare != SkinCompare::off)
    return;
  const SkinView::Timing t = views_.present->timing();
  times_ = {1e-3 * t.final / share, 1e-3 * t.moved()};
  workspace.view.skin.status.milliseconds = 1000 * times_->picture;
  chooser_.measured(shown_.full, *times_);
}

}  // namespace sonoskin::ui
