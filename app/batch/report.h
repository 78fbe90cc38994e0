#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/batch/face_report.h"
#include "app/document/measures.h"
#include "core/mesh/facts/measured_facts.h"
#include "core/mesh/facts/mesh_facts.h"
#include "core/pipeline/pipeline.h"

namespace sonoskin {

// ReportedPart: a part of the surface. Its place names it for mesh.partsAdd and mesh.partsDrop.
struct ReportedPart {
  double area = 0;                          // mm²
  std::array<double, 3> centre{}, place{};  // mm; the place lies on the part
  bool kept = false;
  std::string why;  // a word
};

// Report: what a run did and what it cost. Holds nothing that identifies a patient or a person's folders.
struct Report {
  std::string input;  // file name without folders, or "phantom"
  std::array<int, 3> dims{};
  std::array<double, 3> spacing{};  // mm
  bool spacingKnown = true;
  double isoValue = 0, isoShare = 0;  // the share: of the way from fluid to edge, where it was found
  IsoRange isoRange;                  // what it was found from, and its range from place to place
  std::size_t erasedVoxels = 0;       // of the file of --erase
  std::vector<StageReport> stages;
  std::size_t points = 0, centres = 0, pieces = 0;
  std::vector<ReportedPart> parts;  // largest first; none where whole pieces are chosen
  MeshFacts mesh;
  MeasuredFacts measured;
  std::optional<MeshFacts> print;  // where there is a solid
  double globalError = 0;          // of the fit, as a share of the diagonal of the points' box [thesis 3.22]
  std::optional<double> globalErrorWithWeights;
  EdgeProfile edge;  // across the surface; all zero if the points were not moved onto it
  FaceReport face;
  std::vector<Measure> measures;  // that a person has made
  std::vector<std::string>
      warnings;  // a sentence each: why the surface may not be skin, or not in mm; all that was logged
  std::vector<std::string> notes;  // a sentence each: what was chosen where a file left a choice
  double seconds = 0;              // wall time of everything
  std::size_t peakMemory = 0;      // bytes
  int threads = 0;
  std::string gl;  // renderer and version of OpenGL
  std::vector<std::string> files;
};

// reportParts: the parts of a surface, and which of them are in the mesh.
std::vector<ReportedPart> reportParts(const Results& results);

// reportJson: one JSON object, indented.
std::string reportJson(const Report& report);

// reportText: the same for people, a few lines.
std::string reportText(const Report& report, const std::filesystem::path& folder);

// peakMemoryBytes: the most memory that the process has had at once.
std::size_t peakMemoryBytes();

}  // namespace sonoskin
