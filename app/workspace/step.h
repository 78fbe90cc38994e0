#pragma once

#include <array>
#include <cstddef>

namespace sonoskin {

// Step: one of the parts of the work, in its order; each has a row in the list of steps and parameters of its own.
enum class Step { volume, region, classify, surface, skin, output };

inline constexpr std::array kSteps{Step::volume,  Step::region, Step::classify,
                                   Step::surface, Step::skin,   Step::output};
static_assert(kSteps.size() == std::size_t(Step::output) + 1);

// stepName: names the step for the program: "classify". stepTitle, stepHelp: for people, in the window's language.
const char* stepName(Step step);
const char* stepTitle(Step step);
const char* stepHelp(Step step);

}  // namespace sonoskin
