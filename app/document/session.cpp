#include "app/document/session.h"

#include <algorithm>
#include <utility>

#include "core/base/error_text.h"
#include "core/base/log.h"
#include "core/pipeline/check_ranges.h"
#include "core/pipeline/face_use.h"
#include "core/pipeline/phantom_landmarks.h"
#include "core/pipeline/scan_doubts.h"
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

}  // namespace

Session::Session(const Parameters& parameters)
    : parameters_(drawable(parameters, {})), history_({parameters_}) {}

// A crop box and what was erased belong to their volume: for one of other dimensions both begin anew, and with them
// what undo goes back to. So do landmarks, for any other scan.
void Session::adopt(Opened opened) {
  const Scan& scan = opened.scan;
  const bool resized = hasScan() && scan.volume->geometry.dims != scan_.volume->geometry.dims;
  const bool other = hasScan() && !(scan.key == scan_.key);
  const Key before = parametersKey(parameters_);
  if (other || !hasLandmarks(parameters_.landmarks)) parameters_.landmarks = opened.landmarks;
  if (opened.isAnother && hasScan()) parameters_.scan.spacing = {};
  if (resized) parameters_.region = {};
  const bool changed = !(parametersKey(parameters_) == before);
  const bool anew = resized || changed || erased_.hasStrokes() || scan.erased;
  erased_.reset(scan.volume->geometry);
  if (scan.erased) erased_.become(*scan.erased);
  if (anew) history_ = History<Version>({parameters_, erased_.strokes()});
  scan_ = std::move(opened.scan);
  name_ = opened.name;
  givesSpacing_ = opened.givesSpacing;
  phantom_ = opened.phantom;
  if (opened.isAnother)
    runner_.forget();
  else
    runner_.cancel();
  results_ = {};
  made_ = {};
  meshArea_ = 0;
  warned_.clear();
  ++revision_;
  submit(Goal::classified);
}

// ---- parameters

void Session::edit(const Parameters& parameters) { show(parameters); }

// Makes these the parameters; what is shown live is made anew where it depends on what changed.
void Session::show(const Parameters& given) {
  const Parameters parameters = drawable(given, parameters_.scan);
  const StageKeys before = stageKeys(scan_.key, scan_.erasedKey, parameters_);
  parameters_ = parameters;
  const StageKeys after = currentKeys();
  if (!(after.classified == before.classified)) {
    update(Goal::classified);
  } else if (!(after.points == before.points)) {
    update(Goal::points);
  } else if (!(after.mesh == before.mesh) && mayFollow()) {
    update(Goal::surface);
  }
  respace();
}

// Only the adaptive method is fast enough for that.
bool Session::mayFollow() const {
  return follows_ && results_.mesh && parameters_.reconstruction.method == ReconstructionMethod::adaptive;
}

void Session::followParameters(bool follow) {
  follows_ = follow;
  if (mayFollow() && !meshIsCurrent() && !request_) submit(Goal::surface);
}

// A slider in motion, and a stroke, ask more often than a coarse result or new points take. Each request is left alone
// until that is there, so that the picture follows the mouse; the last one always gets its turn. What goes farther back
// does not wait for what follows from it.
void Session::update(Goal goal) {
  if (answerOwed_ && (request_ == Goal::classified || goal >= request_)) {
    delayed_ = std::min(delayed_.value_or(goal), goal);  // the others follow the first of them
  } else {
    submit(goal);
  }
}

void Session::commitEdit() {
  erased_.endStroke();
  const Version& last = history_.current();
  const bool same = parametersKey(parameters_) == parametersKey(last.parameters);
  if (!same || erased_.strokes() != last.strokes) history_.push({parameters_, erased_.strokes()});
}

void Session::showVersion() {
  erased_.goTo(history_.current().strokes);
  show(history_.current().parameters);
}

void Session::editParts(const MeshOptions& mesh) {
  Parameters parameters = parameters_;
  parameters.mesh = mesh;
  const Key before = currentKeys().mesh;
  edit(parameters);
  commitEdit();
  if (!(currentKeys().mesh == before) && results_.mesh && !mayFollow()) update(Goal::surface);
}

void Session::undo() {
  commitEdit();
  history_.undo();
  showVersion();
}

void Session::redo() {
  history_.redo();
  showVersion();
}

// ---- erasing

void Session::erase(const Brush& brush) {
  if (hasScan() && erased_.paint(brush)) update(Goal::points);
}

void Session::clearErased() {
  erased_.clear();
  show(parameters_);
  commitEdit();
}

// ---- results

bool Session::meshIsCurrent() const { return results_.mesh && made_.mesh == currentKeys().mesh; }

StageKeys Session::currentKeys() const { return stageKeys(scan_.key, erased_.key(), parameters_); }

DocumentState Session::state() const {
  DocumentFacts facts;
  facts.hasScan = hasScan();
  facts.opening = opener_.status().busy;
  facts.working = runner_.status().busy || request_;
  facts.saving = saver_.status().busy;
  facts.stopped = stopped_.has_value();
  facts.failed = failed_;
  facts.hasMesh = results_.mesh != nullptr;
  facts.meshIsCurrent = meshIsCurrent();
  facts.meshIsFinal = meshIsFinal();
  return stateOf(facts);
}

void Session::resume() {
  if (stopped_) submit(*stopped_);
}

bool Session::classifiedIsCoarse() const {
  return results_.classified && results_.classified->geometry.dims != scan_.volume->geometry.dims;
}

void Session::submit(Goal goal) {
  if (!hasScan()) return;
  delayed_.reset();
  stopped_.reset();
  failed_ = false;
  answerOwed_ = goal != Goal::mesh;
  request_ = goal;
  scan_.erased = erased_.snapshot();
  scan_.erasedKey = erased_.key();
  requested_ = {recipeParameters(), scan_.erased, currentKeys().mesh};
  Parameters wanted = parameters_;
  wanted.print.form = PrintForm::none;  // a solid is made when it is saved
  runner_.submit({scan_, wanted, goal, goal == Goal::classified});
}

void Session::reconstruct() { submit(Goal::mesh); }

void Session::cancel() {
  delayed_.reset();
  if (opener_.status().busy) {
    opener_.cancel();
  } else {
    runner_.cancel();
  }
}

// A coarse result holds only the classification; what it lacks stays as it was.
const FaceFit* Session::face() const {
  return isCertain(results_.face.get(), parameters_.face) ? results_.face.get() : nullptr;
}

void Session::takeResults() {
  std::optional<Results> fresh = runner_.takeResults();
  if (!fresh) return;
  answerOwed_ = false;
  if (fresh->mesh) {
    made_ = requested_;
    made_.isFinal = fresh->isFinal;
    meshArea_ = surfaceArea(*fresh->mesh);
    if (request_ == Goal::mesh) ++reconstructions_;
  } else {
    fresh->mesh = results_.mesh;
    fresh->pieces = results_.pieces;
    fresh->parts = results_.parts;
    fresh->verdicts = results_.verdicts;
    fresh->centres = results_.centres;
  }
  if (!fresh->thinned) fresh->thinned = results_.thinned;
  if (!fresh->points) {
    fresh->points = results_.points;
    fresh->edge = results_.edge;
  }
  if (!fresh->face) fresh->face = results_.face;  // sliders do not move it
  if (!fresh->evidence) fresh->evidence = results_.evidence;
  if (fresh->evidence)
    fresh->warnings = doubtsOf(scan_, *fresh->evidence, fresh->face.get(), parameters_.face);
  tellWarnings(fresh->warnings, request_ == Goal::mesh);
  results_ = std::move(*fresh);
  ++revision_;
}

void Session::tellWarnings(const std::vector<std::string>& warnings, bool again) {
  for (const std::string& warning : warnings) {
    const bool known = std::ranges::count(warned_, warning) > 0;
    if (!known || again) log(LogLevel::warning, asSentence(warning));
    if (!known) warned_.push_back(warning);
  }
}

// The points follow the classification as a request of their own, and the surface follows the points: where no surface
// is found, the classified volume is shown all the same.
void Session::finishRequest() {
  const Goal goal = *std::exchange(request_, std::nullopt);
  answerOwed_ = false;
  const Runner::Status status = runner_.status();
  if (status.cancelled) stopped_ = goal;
  if (!status.error.empty()) {
    failed_ = true;
    report(Message::Kind::failure, status.error);
  } else if (!status.cancelled && !delayed_) {
    if (goal == Goal::classified) submit(Goal::points);
    if (goal == Goal::points && mayFollow() && !meshIsCurrent()) submit(Goal::surface);
  }
}

bool Session::poll() {
  const std::uint64_t before = revision_;
  const std::size_t told = messages_.size();
  for (std::string& sentence : opener_.poll()) report(Message::Kind::failure, std::move(sentence));
  for (std::string& sentence : saver_.poll()) report(Message::Kind::failure, std::move(sentence));
  const bool ended = request_ && !runner_.status().busy;
  takeResults();
  if (ended) finishRequest();
  if (delayed_ && !answerOwed_) submit(*delayed_);
  return ended || revision_ != before || messages_.size() != told;
}

Activity Session::activity() const {
  if (const Worker::Status s = opener_.status(); s.busy) return {true, true, s.fraction, s.label};
  // A request counts until its results were taken in.
  if (const Runner::Status s = runner_.status(); s.busy || request_) {
    return {true, request_ == Goal::mesh, s.fraction, s.stage};
  }
  if (const Worker::Status s = saver_.status(); s.busy) return {true, true, s.fraction, s.label};
  return {};
}

std::vector<Message> Session::takeMessages() { return std::exchange(messages_, {}); }

}  // namespace sonoskin
