#include "app/workspace/stages.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/texts/texts.h"
#include "app/widgets/number_text.h"
#include "app/workspace/workspace.h"
#include "core/pipeline/stage_shares.h"

namespace sonoskin {
namespace {

using enum StageState;

// What is not what the parameters lead to: why not.
StageState unfinished(const Session& session, bool there) {
  const DocumentState state = session.state();
  if (state == DocumentState::stopped) return stopped;
  if (state == DocumentState::failed) return failed;
  return there ? stale : nothing;
}

Stage worked(Stage stage, const Workspace& w) {
  const Activity activity = w.session.activity();
  const bool here = w.session.state() == DocumentState::working && stepOfWork(activity.what) == stage.step;
  if (!here) return stage;
  stage.state = working;
  stage.fraction = activity.fraction;
  return stage;
}

Stage volumeStage(const Workspace& w) {
  Stage stage{Step::volume};
  if (w.session.hasScan()) {
    const glm::ivec3 dims = w.session.scan().volume->geometry.dims;
    stage.state = ready;
    stage.number = fmt::format("{} × {} × {}", dims.x, dims.y, dims.z);
  }
  if (w.session.state() == DocumentState::opening) {
    stage.state = working;
    stage.fraction = w.session.activity().fraction;
  }
  return stage;
}

// How much of the volume is left by the crop box, and what was erased of it.
Stage regionStage(const Workspace& w) {
  Stage stage{Step::region};
  if (!w.session.hasScan()) return stage;
  stage.state = ready;
  const Geometry& g = w.session.scan().volume->geometry;
  const RegionOptions& region = w.session.parameters().region;
  double share = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double length = g.spacing[axis] * std::max(g.dims[axis] - 1, 1);
    const double cut = region.cutLow[std::size_t(axis)] + region.cutHigh[std::size_t(axis)];
    share *= std::clamp(1 - cut / length, 0.0, 1.0);
  }
  const double erased = double(w.session.erased().voxels()) / double(w.session.scan().volume->data.size());
  const double left = std::max(share - erased, 0.0);
  stage.number = left >= 1 ? tr("whole volume") : trf("{:.1f} % left", 100 * left);
  return stage;
}

Stage classifyStage(const Workspace& w) {
  Stage stage{Step::classify};
  const Session& session = w.session;
  const bool there = session.results().classified != nullptr;
  stage.state = !session.classifiedIsCurrent() ? unfinished(session, there)
                : session.classifiedIsCoarse()
                    ? (session.state() == DocumentState::working ? live : unfinished(session, there))
                    : ready;
  if (there) stage.number = trf("iso-value {:.2f}", session.results().isoValue);
  stage.seconds = session.secondsOf([](std::string_view name) { return stepOfWork(name) == Step::classify; });
  return worked(std::move(stage), w);
}

Stage surfaceStage(const Workspace& w) {
  Stage stage{Step::surface};
  const Session& session = w.session;
  const Results& results = session.results();
  if (results.mesh) {
    stage.number = trf("{} triangles", ui::grouped(results.mesh->triangles.size()));
    stage.state = !session.meshIsCurrent() ? unfinished(session, true) : session.meshIsFinal() ? ready : live;
  } else {
    if (results.points) stage.number = trf("{} points", ui::grouped(results.points->size()));
    stage.state = unfinished(session, false);
  }
  stage.seconds = session.secondsOf([](std::string_view name) { return stepOfWork(name) == Step::surface; });
  return worked(std::move(stage), w);
}

// The picture of the 3D view, where it shows skin.
Stage skinStage(const Workspace& w) {
  Stage stage{Step::skin};
  const ViewState& view = w.view;
  const bool shown = view.content == SpaceContent::mesh && view.meshStyle == MeshStyle::skin && !view.parts;
  if (!w.session.results().mesh || !shown) return stage;
  const SkinStatus& status = view.skin.status;
  stage.state = !w.session.meshIsCurrent() ? stale : status.settled ? ready : live;
  stage.number = tr(status.full ? "full quality" : "light quality");
  stage.seconds = status.milliseconds / 1000;
  return stage;
}

Stage outputStage(const Workspace& w) {
  Stage stage{Step::output};
  if (w.session.saving()) {
    stage.state = working;
    stage.fraction = w.session.activity().fraction;
  } else if (w.session.hasUnsavedWork()) {
    stage.state = stale;
    stage.number = tr("not saved yet");
  } else if (w.session.results().mesh) {
    stage.state = ready;
    stage.number = tr("saved");
  }
  return stage;
}

}  // namespace

std::array<Stage, kSteps.size()> stagesOf(const Workspace& workspace) {
  return {volumeStage(workspace),  regionStage(workspace), classifyStage(workspace),
          surfaceStage(workspace), skinStage(workspace),   outputStage(workspace)};
}

Step stepOfWork(std::string_view stage) {
  const StageShares shares;
  const bool classifies = stage == "preview" || stage == shares.enhanced.name ||
                          stage == shares.coarser.name || stage == shares.prepared.name ||
                          stage == shares.classified.name;
  return classifies ? Step::classify : Step::surface;
}

const char* stageWord(StageState state) {
  static constexpr std::array<const char*, 7> kWords{"not yet", "working", "ready", "live",
                                                     "stale",   "stopped", "failed"};
  return tr(kWords[std::size_t(state)]);
}

}  // namespace sonoskin
