#include "app/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <utility>

#include "app/parameters_key.h"
#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/mesh_writer.h"
#include "core/io/volume_reader.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/recipe.h"

namespace sonoskin {
namespace fs = std::filesystem;

Session::Session(const Parameters& parameters) : parameters_(parameters), history_(parameters) {}

// ---- opening

void Session::open(const std::string& label, const std::string& name,
                   std::function<Scan(const Progress&)> make) {
  const auto made = std::make_shared<Scan>();
  opener_.replace({label,
                   [made, make = std::move(make)](const Progress& progress) { *made = make(progress); },
                   [this, made, name] { adopt(std::move(*made), name); }});
}

void Session::openFile(const fs::path& path) {
  const std::string name = path.filename().string();
  open("Opening " + name, name, [path](const Progress& progress) { return readScan(path, progress); });
}

void Session::openPhantom() {
  open("Simulating the phantom", "Phantom", [options = parameters_.phantom](const Progress& progress) {
    return makePhantomScan(options, progress);
  });
}

void Session::setSpacing(const glm::dvec3& spacing) {
  open("Setting the spacing", name_, [scan = scan_, spacing](const Progress&) {
    auto volume = std::make_shared<Volume<float>>(*scan.volume);
    volume->geometry.spacing = spacing;
    Scan changed = scan;
    changed.key = scanKey(*volume, scan.beam);
    changed.volume = std::move(volume);
    changed.spacingKnown = true;
    return changed;
  });
}

void Session::adopt(Scan scan, const std::string& name) {
  scan_ = std::move(scan);
  name_ = name;
  runner_.cancel();
  results_ = {};
  meshKey_ = {};
  meshArea_ = 0;
  ++revision_;
  submit(Goal::classified);
}

// ---- parameters

void Session::edit(const Parameters& parameters) { show(parameters); }

// Makes these the parameters; what is shown live is made anew where it depends on what changed.
void Session::show(const Parameters& parameters) {
  const bool changesResults = !(classifiedKey(parameters) == classifiedKey(parameters_));
  const bool changesPoints = !(pointsKey(parameters) == pointsKey(parameters_));
  const bool changesMesh = !(meshKey(parameters) == meshKey(parameters_));
  parameters_ = parameters;
  if (changesResults) {
    update(Goal::classified);
  } else if (changesPoints) {
    update(Goal::points);
  } else if (changesMesh && mayFollow()) {
    update(Goal::surface);
  }
}

// Only the adaptive method is fast enough for that.
bool Session::mayFollow() const {
  return follows_ && results_.mesh && parameters_.reconstruction.method == ReconstructionMethod::adaptive;
}

void Session::followParameters(bool follow) {
  follows_ = follow;
  if (mayFollow() && !meshIsCurrent() && !request_) submit(Goal::surface);
}

// A slider in motion asks more often than a coarse result takes. Each request is left alone until that is
// there, so that the picture follows the slider; the last one always gets its turn.
void Session::update(Goal goal) {
  if (previewOwed_) {
    delayed_ = std::min(delayed_.value_or(goal), goal);  // the others follow the first of them
  } else {
    submit(goal);
  }
}

void Session::commitEdit() {
  if (!(parametersKey(parameters_) == parametersKey(history_.current()))) history_.push(parameters_);
}

void Session::undo() {
  commitEdit();
  history_.undo();
  show(history_.current());
}

void Session::redo() {
  history_.redo();
  show(history_.current());
}

void Session::loadRecipe(const fs::path& path) {
  std::ifstream file(path);
  const std::string json{std::istreambuf_iterator<char>(file), {}};
  require(bool(file), "cannot read {}; check its name and its rights", path.string());
  Parameters read = parameters_;
  readRecipe(json, read);
  show(read);
  commitEdit();
}

// ---- results

bool Session::meshIsCurrent() const {
  return results_.mesh && meshKey_ == Hasher("mesh").add(scan_.key).add(meshKey(parameters_)).key();
}

bool Session::classifiedIsCoarse() const {
  return results_.classified && results_.classified->geometry.dims != scan_.volume->geometry.dims;
}

void Session::submit(Goal goal) {
  if (!hasScan()) return;
  delayed_.reset();
  previewOwed_ = goal == Goal::classified;
  request_ = goal;
  requestKey_ = Hasher("mesh").add(scan_.key).add(meshKey(parameters_)).key();
  runner_.submit({scan_, parameters_, goal, goal == Goal::classified});
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
void Session::takeResults() {
  std::optional<Results> fresh = runner_.takeResults();
  if (!fresh) return;
  previewOwed_ = false;
  if (fresh->mesh) {
    meshKey_ = requestKey_;
    meshIsFinal_ = fresh->isFinal;
    meshArea_ = surfaceArea(*fresh->mesh);
    if (request_ == Goal::mesh) ++reconstructions_;
  } else {
    fresh->mesh = results_.mesh;
    fresh->pieces = results_.pieces;
    fresh->centres = results_.centres;
  }
  if (!fresh->thinned) fresh->thinned = results_.thinned;
  if (!fresh->points) fresh->points = results_.points;
  results_ = std::move(*fresh);
  ++revision_;
}

// The points follow the classification as a request of their own, and the surface follows the points: where no surface
// is found, the classified volume is shown all the same.
void Session::finishRequest() {
  const Goal goal = *std::exchange(request_, std::nullopt);
  previewOwed_ = false;
  const Runner::Status status = runner_.status();
  if (!status.error.empty()) {
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
  if (delayed_ && !previewOwed_) submit(*delayed_);
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

// ---- saving

void Session::save(const fs::path& path, std::function<void(const Progress&)> write) {
  const std::string recipe = writeRecipe(parameters_, scan_.key);
  saver_.append({"Saving " + path.filename().string(),
                 [path, recipe, write = std::move(write)](const Progress& progress) {
                   write(progress);
                   const fs::path beside = fs::path(path).replace_extension(".recipe.json");
                   writeBytes(beside, recipe.data(), recipe.size());
                 },
                 [this, path] { report(Message::Kind::note, "Saved " + path.string()); }});
}

std::string Session::proposedName(const std::string& ending) const {
  const std::string stem = name_.substr(0, name_.find('.'));
  return (stem.empty() ? "sonoskin" : stem) + ending;
}

void Session::saveMesh(const fs::path& path) {
  require(results_.mesh != nullptr, "there is no surface to save yet; reconstruct it first");
  save(path, [path, mesh = results_.mesh](const Progress& progress) { writeMesh(path, *mesh, progress); });
}

void Session::savePicture(const fs::path& path, Image image) {
  const auto picture = std::make_shared<Image>(std::move(image));
  save(path, [path, picture](const Progress&) { writePng(path, *picture); });
}

void Session::saveRecipe(const fs::path& path) {
  saver_.append({"Saving " + path.filename().string(),
                 [path, recipe = writeRecipe(parameters_, scan_.key)](const Progress&) {
                   writeBytes(path, recipe.data(), recipe.size());
                 },
                 [this, path] { report(Message::Kind::note, "Saved " + path.string()); }});
}

}  // namespace sonoskin
