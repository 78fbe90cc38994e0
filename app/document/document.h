#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/document/erased_parts.h"
#include "app/document/history.h"
#include "app/document/view_edits.h"
#include "core/pipeline/parameters.h"
#include "core/volume/scan.h"

namespace sonoskin {

// Opened: a scan, what it is called, and where the parts of its face are, if that is known.
struct Opened {
  Scan scan;
  std::string name;
  LandmarkOptions landmarks{};
  bool givesSpacing = true;                 // the scan's own file does; otherwise scan.spacing is its spacing
  bool isAnother = true;                    // not the one that is open, with another spacing
  std::optional<PhantomOptions> phantom{};  // what a simulated scan was made with
  ScanOptions
      reading{};  // volume, time, voxel, mirror, regionOnly, half, cutLow, cutHigh: which it is, and how it was read
  RawOptions raw{};                // what its file was told to hold
  std::filesystem::path source{};  // of a scan from a file, from which another time step may be asked for
  std::optional<Parameters> parameters{};  // those that it brings, as a session does
};

// Version: what undo goes back to.
struct Version {
  Parameters parameters;
  std::size_t strokes = 0;  // of the eraser
  std::size_t erased = 0;   // voxels
  ViewEdits views{};
};

// Document: what belongs to the baby, whichever moment of it is looked at (Frame): where it comes from, the parameters, among
// them landmarks, crop box and marks of parts, what was erased, what a person made in the views, and the history of these. A
// recipe holds this, but what was made in the views.
struct Document {
  explicit Document(const Parameters& parameters);

  // change: other parameters, brought within their ranges and with beams.
  void change(const Parameters& given);
  // commit: makes what was changed and erased since the last step one step, that undo() takes back.
  void commit();
  void undo();
  void redo();
  // goTo: to a version of the history; what was changed since the last step becomes one before.
  void goTo(std::size_t version);
  // beginViews: what there is in the views where the document begins: no step leads behind it.
  void beginViews(const ViewEdits& begun);
  // adopt: another volume in the place of the present one, or the same with another spacing. A crop box and what was erased
  // belong to a volume's dimensions, landmarks to a face: where these are others they begin anew, and with them what undo
  // goes back to.
  //   before  the present scan; without a volume where there is none
  void adopt(const Opened& opened, const Scan& before);

  std::string name;
  bool givesSpacing = true;
  std::optional<PhantomOptions> phantom;  // of the scan, where it is simulated
  ScanOptions reading;  // volume, time, voxel, mirror, half, cutLow, cutHigh: which scan, and how it was read
  RawOptions raw;       // what its file was told to hold
  std::filesystem::path source;  // of the scan, where it is from a file
  Parameters parameters;
  ErasedParts erased;
  ViewEdits views;
  History<Version> history;
};

// contentKey: of what a person chose for a document, all parameters but those that name a scan, a time step or a way to read
// it. What is erased is not part of it.
Key contentKey(const Parameters& parameters);

// recipeParameters: the parameters, with those that the scan at hand was simulated and read with.
Parameters recipeParameters(const Document& document);

}  // namespace sonoskin
