#include "app/document/session.h"

#include <algorithm>
#include <utility>

#include "core/base/error_text.h"
#include "core/base/log.h"
#include "core/pipeline/face_use.h"
#include "core/pipeline/stage_keys.h"

namespace sonoskin {

Session::Session(const Parameters& parameters) : document_(parameters) {}

void Session::adopt(Opened opened) {
  document_.adopt(opened, frame_.scan);
  if (opened.isAnother)
    runner_.forget();
  else
    runner_.cancel();
  frame_ = {};
  frame_.scan = std::move(opened.scan);
  steps_.clear();
  if (opened.isAnother) saved_ = {contentKey(document_.parameters), document_.erased.key(), {}};
  surfaceOwed_ = false;
  older_.reset();
  asked_ = 0;
  turned_ = document_.reading.mirror;
  warned_.clear();
  ++opened_;
  ++revision_;
  submit(Goal::classified);
}

// ---- parameters

void Session::edit(const Parameters& parameters) {
  change([&](Document& document) { document.change(parameters); });
}

void Session::change(const std::function<void(Document&)>& edit) {
  const StageKeys before = stageKeys(frame_.scan.key, frame_.scan.erasedKey, document_.parameters);
  edit(document_);
  const StageKeys after = keysOf(document_, frame_);
  if (!(after.classified == before.classified)) {
    update(Goal::classified);
  } else if (!(after.points == before.points)) {
    update(Goal::points);
  } else if (!(after.mesh == before.mesh) && mayFollow()) {
    update(Goal::surface);
  }
  respace();
  retime();
  turnOver();
}

// Only the adaptive method is fast enough for that.
bool Session::mayFollow() const {
  return follows_ && frame_.results.mesh &&
         document_.parameters.reconstruction.method == ReconstructionMethod::adaptive;
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

void Session::commitEdit() { document_.commit(); }

void Session::editParts(const MeshOptions& mesh) {
  Parameters parameters = document_.parameters;
  parameters.mesh = mesh;
  const Key before = keysOf(document_, frame_).mesh;
  edit(parameters);
  commitEdit();
  const bool differs = !(keysOf(document_, frame_).mesh == before);
  if (differs && frame_.results.mesh && !mayFollow()) update(Goal::surface);
}

void Session::editViews(const ViewEdits& edits) {
  document_.views = edits;
  commitEdit();
}

void Session::undo() { change(&Document::undo); }

void Session::redo() { change(&Document::redo); }

void Session::goToStep(std::size_t step) {
  change([step](Document& document) { document.goTo(step); });
}

// ---- erasing

void Session::erase(const Brush& brush) {
  if (hasScan() && document_.erased.paint(brush)) update(Goal::points);
}

void Session::erase(const Lasso& lasso) {
  if (hasScan() && document_.erased.paint(lasso)) update(Goal::points);
}

void Session::clearErased() {
  change([](Document& document) { document.erased.clear(); });
  commitEdit();
}

// ---- results

DocumentState Session::state() const {
  DocumentFacts facts;
  facts.hasScan = hasScan();
  facts.opening = opener_.status().busy;
  facts.working = runner_.status().busy || request_;
  facts.saving = saver_.status().busy;
  facts.stopped = stopped_.has_value();
  facts.failed = failed_;
  facts.hasMesh = frame_.results.mesh != nullptr;
  facts.meshIsCurrent = meshIsCurrent();
  facts.meshIsFinal = meshIsFinal();
  return stateOf(facts);
}

void Session::resume() {
  if (stopped_) submit(*stopped_);
}

bool Session::classifiedIsCoarse() const {
  const auto& classified = frame_.results.classified;
  return classified && classified->geometry.dims != frame_.scan.volume->geometry.dims;
}

bool Session::classifiedIsCurrent() const {
  return frame_.results.classified && frame_.results.keys.classified == keysOf(document_, frame_).classified;
}

double Session::secondsOf(bool (*which)(std::string_view stage)) const {
  double sum = 0;
  for (const auto& [stage, seconds] : frame_.seconds) sum += which(stage) ? seconds : 0;
  return sum;
}

void Session::submit(Goal goal) {
  if (!hasScan()) return;
  delayed_.reset();
  stopping_.reset();
  stopped_.reset();
  failed_ = false;
  answerOwed_ = goal != Goal::mesh;
  request_ = goal;
  frame_.scan.erased = document_.erased.snapshot();
  frame_.scan.erasedKey = document_.erased.key();
  const OlderSurface wanted = makesOlder(goal) ? *older_ : OlderSurface{frame_.scan, document_.parameters};
  const Key mesh = stageKeys(wanted.scan.key, wanted.scan.erasedKey, wanted.parameters).mesh;
  requested_ = {makesOlder(goal) ? wanted.parameters : recipeParameters(document_), wanted.scan.erased, mesh};
  Runner::Request request{wanted.scan, wanted.parameters, goal, goal == Goal::classified};
  request.parameters.print.form = PrintForm::none;  // a solid is made when it is saved
  if (lookedAt_) request.slicesFirst = glm::round(frame_.scan.volume->geometry.toIndex(*lookedAt_));
  runner_.submit(std::move(request));
}

void Session::reconstruct() {
  ++longJobs_;
  older_.reset();
  submit(Goal::mesh);
}

// What waits behind a request begins before it or with it.
void Session::cancel() {
  if (opener_.status().busy) {
    opener_.cancel();
    return stayWithScan();
  }
  if (!request_) return;
  stopping_ = std::min(*request_, delayed_.value_or(*request_));
  delayed_.reset();
  runner_.cancel();
}

const FaceFit* Session::face() const {
  const FaceFit* face = frame_.results.face.get();
  return isCertain(face, document_.parameters.face) ? face : nullptr;
}

void Session::takeResults() {
  std::optional<Results> fresh = runner_.takeResults();
  if (!fresh) return;
  if (fresh->classified) answerOwed_ = false;  // else slices alone: the coarse volume follows at once
  const bool askedFor = fresh->mesh && request_ == Goal::mesh, reopened = askedFor && surfaceOwed_;
  if (makesOlder(request_)) {
    if (!fresh->mesh) return;  // what the older one is made from is not what is open
    fresh = withSurfaceOf(frame_.results, *fresh);
  }
  takeIn(frame_, std::move(*fresh), requested_, document_.parameters.face);
  if (reopened) {
    surfaceOwed_ = false;
    older_.reset();
    saved_.mesh = frame_.made.key();
  } else if (askedFor) {
    ++reconstructions_;
  }
  tellWarnings(frame_.results.warnings, request_ == Goal::mesh);
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
  const std::string error = runner_.status().error;
  if (!error.empty()) {
    failed_ = true;
    stopping_.reset();
    report(Message::Kind::failure, error);
  } else if (stopping_) {
    stopped_ = std::exchange(stopping_, std::nullopt);
  } else if (!delayed_) {
    if (goal == Goal::classified) submit(Goal::points);
    if (goal != Goal::points) return;
    if (surfaceOwed_)
      submit(Goal::mesh);
    else if (mayFollow() && !meshIsCurrent())
      submit(Goal::surface);
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
