#include "app/workspace/time_play.h"

#include <algorithm>

#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

constexpr double kStepSeconds = 0.1;  // where the recording does not tell
constexpr double kLeastSeconds = 1.0 / 30, kMostSeconds = 1;

}  // namespace

void showStep(Workspace& workspace, int time) {
  Parameters parameters = workspace.session.parameters();
  parameters.scan.time = std::clamp(time, 1, workspace.session.scan().timeSteps);
  workspace.session.edit(parameters);
}

StepRange stepsOf(const Workspace& workspace) {
  const int steps = workspace.session.scan().timeSteps, last = workspace.play.last;
  const int end = last >= 1 ? std::min(last, steps) : steps;
  return {std::clamp(workspace.play.first, 1, end), end};
}

void stepBy(Workspace& workspace, int steps) {
  const StepRange range = stepsOf(workspace);
  const int next = workspace.session.parameters().scan.time + steps;
  showStep(workspace, next > range.last ? range.first : next < range.first ? range.last : next);
  workspace.play.sinceStep = {};
}

void play(Workspace& workspace, bool on) {
  workspace.play.on = on && workspace.session.scan().timeSteps > 1;
  workspace.play.sinceStep = {};
  if (!on) workspace.session.commitEdit();
}

double playOn(Workspace& workspace) {
  const Session& session = workspace.session;
  if (!workspace.play.on) return -1;
  const bool busy = session.activity().busy;
  if (!session.hasScan() || session.scan().timeSteps < 2 || (!busy && !session.isAtTime())) {
    play(workspace, false);
    return -1;
  }
  const double told = session.scan().stepSeconds > 0 ? session.scan().stepSeconds : kStepSeconds;
  const double seconds = std::clamp(told, kLeastSeconds, kMostSeconds);
  const double left = seconds - workspace.play.sinceStep.seconds();
  if (busy || left > 0) return std::max(left, 0.02);
  stepBy(workspace, 1);
  return 0;
}

}  // namespace sonoskin
