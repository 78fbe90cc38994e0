#include "app/views/skin_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

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
  const auto made = std::make_shared<std::shared_ptr<const SkinSurface>>();
  const glm::vec3 front = homeOf(workspace).back;
  worker_->replace({"Preparing skin",
                    [made, wanted, front](const Progress& progress) {
                      const SkinQuality quality = wanted.full ? fullQuality() : lightQuality();
                      *made = prepareSkin(wanted.mesh, front, quality, progress);
                    },
                    [this, made, wanted] {
                      prepared_ = *made;
                      ++preparations_;
                      shown_ = wanted;
                      times_.reset();
                      lit_ = false;
                      drawn_ = 0;
                    }});
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
       {worker_ ? worker_->status() : Worker::Status{}, present_.refiner.status(), kept_.refiner.status()})
    if (status.busy) return fmt::format("{}  {:.0f} %", status.label, 100 * status.fraction);
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
  return shot;
}

void drawSkin(const SkinShot& shot, const Camera& camera, const GpuSkin& gpu, SkinView& present,
              std::optional<SkinView>& kept, const SkinPictureOptions& options, const gl::Target& target) {
  const auto draw = [&](SkinView& view, const SkinSettings& settings, SkinPass pass, glm::vec2 part) {
    const SkinLook look = lookOf(settings, shot.home, gpu.box());
    SkinViewInput input{.surface = gpu, .camera = camera, .look = look, .quality = shot.quality};
    input.supersampling = options.supersampling;
    input.steps = options.steps;
    input.pass = pass;
    input.shownPart = part;
    input.unseenShade = shot.unseenShade;
    view.draw(input, target);
  };
  const bool split = shot.compare != SkinCompare::off;
  draw(present, shot.settings, shot.pass, {split ? shot.divider : 0, 1});
  if (!split) return;
  const glm::vec2 left(0, shot.divider);
  if (shot.compare == SkinCompare::scatter) return draw(present, shot.settings, SkinPass::undiffused, left);
  if (!kept) kept.emplace();
  draw(*kept, shot.kept, shot.pass, left);
}

void SkinScene::draw(const Workspace& workspace, int supersampling, const gl::Target& target) {
  if (!surface_) surface_.emplace();
  if (!present_.view) present_.view.emplace();
  surface_->set(prepared_);
  const bool smooth = supersampling > 1;
  SkinShot now = shot(workspace);
  now.quality.points = smooth;
  const bool atOnce = smooth || (times_ && times_->light < kLightAtOnce);
  const SkinPictureOptions options{supersampling, atOnce ? 1000 : 1};
  drawSkin(now, workspace.view.camera, *surface_, *present_.view, kept_.view, options, target);
  compared_ = now.compare == SkinCompare::settings;
  complete_ = present_.view->complete() && (!compared_ || kept_.view->complete());
  lit_ = lit_ || present_.view->complete();
}

void SkinScene::refine(Lit& lit, const SkinSettings& settings, bool rests) {
  Hasher hasher("refined light");
  hasher.add(preparations_);
  addSettings(hasher, settings);
  refined_ += lit.refiner.update(*lit.view, *surface_, prepared_, settings.skin, hasher.key(), rests) ? 1 : 0;
}

std::vector<std::string> SkinScene::refine(const Workspace& workspace, bool rests) {
  if (!shows(workspace) || !complete_ || !present_.view) {
    present_.refiner.cancel();
    kept_.refiner.cancel();
    return {};
  }
  if (!compared_) kept_.refiner.cancel();
  const SkinSettings present = presentSettings(workspace);
  refine(present_, present, rests);
  if (compared_) refine(kept_, workspace.view.skin.kept.value_or(present), rests);
  std::vector<std::string> failures = present_.refiner.failures();
  std::ranges::move(kept_.refiner.failures(), std::back_inserter(failures));
  return failures;
}

bool SkinScene::refined() const {
  return present_.view && present_.view->byPoints() && (!compared_ || kept_.view->byPoints());
}

void SkinScene::note(Workspace& workspace, double share) {
  if (!present_.view || !complete_ || ++drawn_ < kSettled || workspace.view.skin.compare != SkinCompare::off)
    return;
  const SkinView::Timing t = present_.view->timing();
  times_ = {1e-3 * t.final / share, 1e-3 * (t.lightMaps + t.visibility + t.irradiance + t.blurs + t.combine)};
  workspace.view.skin.status.milliseconds = 1000 * times_->picture;
  chooser_.measured(shown_.full, *times_);
}

}  // namespace sonoskin::ui
