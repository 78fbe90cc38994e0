#include "app/document/document.h"

#include <utility>

#include "core/pipeline/check_ranges.h"
#include "core/pipeline/phantom_landmarks.h"
#include "core/pipeline/stage_keys.h"

namespace sonoskin {
namespace {

// Whoever sets parameters, an editor, a recipe or what a window was started with: what is drawn needs numbers within their
// ranges, and beams, at any time.
Parameters drawable(Parameters given, const ScanOptions& before) {
  given = withinRanges(std::move(given));
  given.scan = sidesApart(given.scan, before);
  return given;
}

void showVersion(Document& document) {
  const Version& version = document.history.current();
  document.erased.goTo(version.strokes);
  document.views = version.views;
  document.change(version.parameters);
}

}  // namespace

Document::Document(const Parameters& given) : parameters(drawable(given, {})), history({parameters}) {}

void Document::change(const Parameters& given) { parameters = drawable(given, parameters.scan); }

void Document::commit() {
  erased.endStroke();
  const Version& last = history.current();
  const bool same = parametersKey(parameters) == parametersKey(last.parameters);
  if (!same || erased.strokes() != last.strokes || !(views == last.views))
    history.push({parameters, erased.strokes(), erased.voxels(), views});
}

void Document::beginViews(const ViewEdits& begun) {
  bool edited = false;
  for (std::size_t n = 1; n < history.size(); ++n)
    edited = edited || !(history.at(n).views == history.at(n - 1).views);
  views = begun;
  if (edited)  // steps without what they changed would be none
    history = History<Version>({parameters, erased.strokes(), erased.voxels(), views});
  else
    history.changeAll([&](Version& version) { version.views = begun; });
}

void Document::undo() {
  commit();
  history.undo();
  showVersion(*this);
}

void Document::redo() {
  history.redo();
  showVersion(*this);
}

void Document::goTo(std::size_t version) {
  commit();
  history.goTo(version);
  showVersion(*this);
}

void Document::adopt(const Opened& opened, const Scan& before) {
  const Scan& scan = opened.scan;
  const bool resized = before.volume && scan.volume->geometry.dims != before.volume->geometry.dims;
  const bool other = before.volume && !(scan.key == before.key);
  const Key past = parametersKey(parameters);
  if (other || !hasLandmarks(parameters.landmarks)) parameters.landmarks = opened.landmarks;
  if (opened.isAnother && before.volume) parameters.scan.spacing = {};
  if (resized) parameters.region = {};
  if (opened.parameters) parameters = drawable(*opened.parameters, {});
  const bool changed = !(parametersKey(parameters) == past);
  const bool anew = opened.parameters || resized || changed || erased.hasStrokes() || scan.erased;
  erased.reset(scan.volume->geometry);
  if (scan.erased) erased.become(*scan.erased);
  if (anew) history = History<Version>({parameters, erased.strokes(), erased.voxels(), views});
  name = opened.name;
  givesSpacing = opened.givesSpacing;
  reading = opened.reading;
  raw = opened.raw;
  source = opened.source;
  parameters.scan.volume = reading.volume;
  parameters.scan.time = reading.time;
  parameters.scan.mirror = reading.mirror;
  phantom = opened.phantom;
}

Key contentKey(const Parameters& given) {
  Parameters parameters = given;
  const ScanOptions reading{};
  parameters.phantom = {};
  parameters.raw = {};
  parameters.scan.volume = reading.volume;
  parameters.scan.time = reading.time;
  parameters.scan.regionOnly = reading.regionOnly;
  parameters.scan.half = reading.half;
  parameters.scan.cutLow = reading.cutLow;
  parameters.scan.cutHigh = reading.cutHigh;
  parameters.scan.voxel = reading.voxel;
  return parametersKey(parameters);
}

Parameters recipeParameters(const Document& document) {
  Parameters parameters = document.parameters;
  if (document.phantom) parameters.phantom = *document.phantom;
  parameters.raw = document.raw;
  parameters.scan.volume = document.reading.volume;
  parameters.scan.time = document.reading.time;
  parameters.scan.regionOnly = document.reading.regionOnly;
  parameters.scan.half = document.reading.half;
  parameters.scan.cutLow = document.reading.cutLow;
  parameters.scan.cutHigh = document.reading.cutHigh;
  parameters.scan.voxel = document.reading.voxel;
  parameters.scan.mirror = document.reading.mirror;
  return parameters;
}

}  // namespace sonoskin
