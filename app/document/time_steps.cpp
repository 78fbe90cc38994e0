#include "app/document/time_steps.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/error_text.h"
#include "core/base/log.h"

namespace sonoskin {
namespace {

constexpr double kRead = 0.3, kComputed = 0.7;  // shares of a step's time

}  // namespace

std::vector<NoSurface> makeSurfaces(const StepLoader& load, const Parameters& parameters, StepRange steps,
                                    const StepTaker& take, const Progress& progress) {
  std::vector<NoSurface> missing;
  Scan scan = load(steps.first, progress.cancelOnly());
  steps = stepsWithin(steps, scan.timeSteps);
  const int count = steps.last - steps.first + 1;
  for (int n = 0; n < count; ++n) {
    const int time = steps.first + n;
    const Progress step = progress.part(double(n) / count, double(n + 1) / count);
    if (n > 0) scan = load(time, step.part(0, kRead));
    try {
      Pipeline pipeline;
      take({time, scan, pipeline.run(scan, parameters, Goal::mesh, step.part(kRead, kComputed))},
           step.part(kComputed, 1));
    } catch (const Error& error) {
      if (error.kind() != Error::Kind::input) throw;
      missing.push_back({time, error.what()});
      log(LogLevel::warning, fmt::format("Time step {} has no surface: {}", time, asSentence(error.what())));
    }
  }
  if (int(missing.size()) == count)
    throw Error(fmt::format("No time step has a surface: {}", missing.front().why));
  return missing;
}

}  // namespace sonoskin
