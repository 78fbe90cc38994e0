#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/batch/batch.h"
#include "app/document/time_steps.h"

namespace sonoskin {

// ReportedStep: what was made of one time step.
struct ReportedStep {
  int time = 1;
  std::size_t points = 0, triangles = 0;
  double area = 0;  // mm²
  double isoValue = 0;
  FaceReport face;
};

// SequenceReport: what a run over time steps did. Holds nothing that identifies a patient or a person's folders.
struct SequenceReport {
  std::string input;
  int timeSteps = 1;       // of the recording
  double stepSeconds = 0;  // from one to the next; 0: the file does not tell
  std::vector<ReportedStep> steps;
  std::vector<NoSurface> missing;
  std::vector<std::string> warnings, notes;
  double seconds = 0;
  std::vector<std::string> files;
};

// runSequence: the whole way for each of some time steps with the same parameters, to a folder with mesh_0001.<format>, ...,
// skin_0001.png, ... as one camera sees them, film.mp4 where the program ffmpeg is there, recipe.json and report.json.
//   errors  as runBatch and makeSurfaces; nothing is written then
SequenceReport runSequence(const BatchOptions& options, StepRange steps, const Progress& progress = {},
                           const Pipeline::StageBegins& stageBegins = {});

std::string sequenceJson(const SequenceReport& report);
std::string sequenceText(const SequenceReport& report, const std::filesystem::path& folder);

}  // namespace sonoskin
