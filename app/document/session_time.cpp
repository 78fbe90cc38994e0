// The session's time steps: scans of one recording, which share a document.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "app/document/input.h"
#include "app/document/session.h"
#include "app/document/time_steps.h"
#include "core/base/error.h"
#include "core/io/file_formats.h"
#include "core/io/mesh_writer.h"
#include "core/io/volume_reader.h"
#include "core/volume/mirror_scan.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

// What is kept of a recording beside the step that is looked at: those that were seen last.
constexpr std::size_t kKeptSteps = 16, kKeptBytes = 256u << 20;

std::size_t bytesOf(const Scan& scan) { return scan.volume->data.size() * sizeof(float); }

void keep(std::deque<Scan>& steps, Scan scan) {
  scan.erased.reset();
  steps.push_front(std::move(scan));
  std::size_t bytes = 0, count = 0;
  while (count < std::min(steps.size(), kKeptSteps) && bytes + bytesOf(steps[count]) <= kKeptBytes)
    bytes += bytesOf(steps[count++]);
  steps.resize(count);
}

// A step as the document's first one was read.
Scan readStep(const fs::path& source, const ScanOptions& options, const RawOptions& raw,
              const Progress& progress) {
  Scan scan = readScan(source, readOptions(options, raw), progress);
  if (!scan.spacingKnown) setSpacing(scan, options.spacing);
  fitIntoMemory(scan, options);
  mirrorScan(scan, options.mirror);
  return scan;
}

// What was erased, and the box, belong to one grid: samples of beams become larger voxels where memory has become short.
void requireGrid(const Scan& scan, const Geometry& geometry) {
  require(scan.volume->geometry.dims == geometry.dims,
          "Time step {} has other voxels than the one before; open the file anew.", scan.time);
}

}  // namespace

// Asked for once, whether or not there is such a step; a slider that moves on replaces what it asked for.
void Session::retime() {
  const int time = document_.parameters.scan.time;
  if (!hasScan() || document_.source.empty() || time == asked_) return;
  if (time == frame_.scan.time) {
    if (asked_ != 0) opener_.cancel();
    asked_ = 0;
    return;
  }
  asked_ = time;
  const auto kept = std::ranges::find_if(steps_, [time](const Scan& scan) { return scan.time == time; });
  if (kept != steps_.end()) {
    Scan scan = std::move(*kept);
    steps_.erase(kept);
    return adoptStep(std::move(scan));
  }
  ScanOptions options = document_.reading;
  options.spacing = document_.parameters.scan.spacing;
  options.time = time;
  const auto scan = std::make_shared<Scan>();
  opener_.replace({fmt::format("Reading time step {}", time),
                   [scan, source = document_.source, options, raw = document_.raw,
                    geometry = frame_.scan.volume->geometry](const Progress& progress) {
                     *scan = readStep(source, options, raw, progress);
                     requireGrid(*scan, geometry);
                   },
                   [this, scan] { adoptStep(std::move(*scan)); }});
}

// A scan that is not read after all leaves time, axes and spacing as those of the scan that stays.
void Session::stayWithScan() {
  asked_ = 0;
  turned_ = document_.reading.mirror;
  if (!hasScan() || document_.source.empty()) return;
  Parameters parameters = document_.parameters;
  parameters.scan.time = frame_.scan.time;
  parameters.scan.mirror = turned_;
  const Scan& scan = frame_.scan;
  const glm::dvec3& mm = scan.volume->geometry.spacing;
  if (!document_.givesSpacing)
    parameters.scan.spacing = scan.spacingKnown ? std::array{mm.x, mm.y, mm.z} : std::array<double, 3>{};
  document_.change(parameters);
}

// Another axis that is turned over, or none, makes another scan of the same voxels: its landmarks begin anew.
void Session::turnOver() {
  const MirroredAxis mirror = document_.parameters.scan.mirror;
  if (!hasScan() || document_.source.empty() || mirror == turned_) return;
  turned_ = mirror;
  ScanOptions options = document_.reading;
  options.spacing = document_.parameters.scan.spacing;
  options.mirror = mirror;
  Opened opened{{}, document_.name};
  opened.givesSpacing = document_.givesSpacing;
  opened.isAnother = false;
  opened.reading = options;
  opened.raw = document_.raw;
  opened.source = document_.source;
  open("Turning an axis over", std::move(opened), [](Opened& made, const Progress& progress) {
    made.scan = readStep(made.source, made.reading, made.raw, progress);
  });
}

// The document stays as it is: landmarks, box, erased parts and look go along. What was made of the step before stays in
// sight until there is something newer.
void Session::adoptStep(Scan scan) {
  keep(steps_, std::exchange(frame_.scan, std::move(scan)));
  document_.reading.time = frame_.scan.time;
  asked_ = 0;
  runner_.cancel();
  ++revision_;
  submit(Goal::classified);
}

void Session::saveSequence(const fs::path& path, StepRange steps) {
  require(hasScan() && !document_.source.empty(), "There is no recording to save surfaces of; open one.");
  requireFormat(FileKind::writtenMesh, path);
  ++longJobs_;
  Parameters parameters = recipeParameters(document_);
  parameters.print.form = PrintForm::none;
  ScanOptions options = document_.reading;
  options.spacing = document_.parameters.scan.spacing;
  const auto load = [source = document_.source, options, raw = document_.raw,
                     geometry = frame_.scan.volume->geometry, erased = document_.erased.snapshot(),
                     key = document_.erased.key()](int time, const Progress& progress) mutable {
    options.time = time;
    Scan scan = readStep(source, options, raw, progress);
    requireGrid(scan, geometry);
    scan.erased = erased;
    scan.erasedKey = key;
    return scan;
  };
  const auto write = [path](const StepSurface& step, const Progress& progress) {
    const std::string name =
        fmt::format("{}_{:04}{}", path.stem().string(), step.time, path.extension().string());
    writeMesh(path.parent_path() / name, *step.results.mesh, progress);
  };
  save(path, recipeNow(), [load, parameters, steps, write](const Progress& progress) {
    makeSurfaces(load, parameters, steps, write, progress);
  });
}

}  // namespace sonoskin
