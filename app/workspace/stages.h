#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "app/workspace/step.h"

namespace sonoskin {

struct Workspace;

// StageState: how far the result of a step can be relied on.
//   nothing   there is none yet
//   working   it is being made
//   ready     it is what the parameters lead to
//   live      the same, made with short cuts: on larger voxels, or while a slider moved
//   stale     older than the parameters
//   stopped   a person ended the work before it was done
//   failed    it could not be made; a message says why
enum class StageState { nothing, working, ready, live, stale, stopped, failed };

// Stage: what the list of steps says of one of them.
//   number    of what there is: "18,433 points"; empty for nothing
//   seconds   that it took last; 0: not known
//   fraction  of the work that is done, while working
struct Stage {
  Step step = Step::volume;
  StageState state = StageState::nothing;
  std::string number{};
  double seconds = 0, fraction = 0;
};

// stagesOf: of all steps, in their order.
std::array<Stage, kSteps.size()> stagesOf(const Workspace& workspace);

// stepOfWork: the step to which a stage of the pipeline belongs, by its name in reports and progress.
Step stepOfWork(std::string_view stage);

// stageWord: a word for people, in the window's language.
const char* stageWord(StageState state);

}  // namespace sonoskin
