#include "app/panels/export_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/batch/turntable_files.h"
#include "app/texts/texts.h"
#include "core/base/error.h"

namespace sonoskin::ui {
namespace {

namespace fs = std::filesystem;

bool hasScan(const Workspace& w) { return w.session.hasScan(); }
bool hasMesh(const Workspace& w) { return w.session.results().mesh != nullptr; }
bool hasPoints(const Workspace& w) { return w.session.results().points != nullptr; }
bool hasThinned(const Workspace& w) { return w.session.results().thinned != nullptr; }
bool hasClassified(const Workspace& w) {
  return w.session.results().classified && !w.session.classifiedIsCoarse();
}
bool showsSkin(const Workspace& w) {
  return hasMesh(w) && w.view.content == SpaceContent::mesh && w.view.meshStyle == MeshStyle::skin;
}

constexpr const char* kNoSurface = "There is no surface yet; reconstruct it first (Ctrl+Enter).";
constexpr const char* kNotReady = "This is not ready yet; wait until the step Classify is.";
constexpr const char* kNoSkin = "The 3D view does not show skin; choose Mesh and Skin there.";
constexpr const char* kNoScan = "There is no scan; open one.";

const std::array<ExportItem, 10> kItems{
    ExportItem{"mesh", "Surface", "The triangles, for programs that measure, print or show them.",
               FilePurpose::saveMesh, "surface", hasMesh, kNoSurface},
    {"skin", "Surface with skin", "The triangles with maps of colour, normals and roughness.",
     FilePurpose::saveSkin, "skin", showsSkin, kNoSkin},
    {"print", "Solid to print", "A closed shell or block, as the step Export describes it.",
     FilePurpose::savePrint, "print", hasMesh, kNoSurface},
    {"points", "Points", "The places where the surface was found, with their normals.",
     FilePurpose::savePoints, "points", hasPoints, kNotReady},
    {"scan", "Scan", "The volume as it was read, 0 to 1.", FilePurpose::saveScan, "scan", hasScan, kNoScan},
    {"classified", "Classified volume", "Near 1 on surfaces, 0 elsewhere.", FilePurpose::saveClassified,
     "classified", hasClassified, kNotReady},
    {"thinned", "Thinned volume", "The surface voxels alone, 1 to 255; 0 elsewhere.",
     FilePurpose::saveThinned, "thinned", hasThinned, kNotReady},
    {"picture", "Picture", "What the 3D view shows, without its marks.", FilePurpose::savePicture, "picture",
     hasScan, kNoScan},
    {"turntable", "Turntable",
     "Pictures all around what the 3D view shows, and a film where ffmpeg is there.",
     FilePurpose::saveTurntable, "turntable", hasScan, kNoScan},
    {"report", "Report", "Sizes, the face's places, parts of the surface, and what was measured.",
     FilePurpose::saveReport, "report", hasMesh, kNoSurface}};

}  // namespace

std::span<const ExportItem> exportItems() { return kItems; }

namespace {

// What a file of a format holds; of a purpose, where the table of formats speaks of others.
const char* keeps(FilePurpose purpose, FileFormat format) {
  if (purpose == FilePurpose::savePoints) return "mm; places and normals, without triangles";
  if (purpose == FilePurpose::saveReport) return format == FileFormat::text ? "for people" : "for programs";
  return formatKeeps(format).data();  // a literal
}

}  // namespace

std::vector<ExportFormat> exportFormats(const ExportItem& item) {
  const FileKind kind = purposeText(item.purpose).kind;
  std::vector<ExportFormat> formats;
  for (const std::string& ending : extensionsOf(kind)) {
    const FileFormat format = *formatNamed(kind, "x" + ending);
    formats.push_back({ending, std::string(formatName(format)), tr(keeps(item.purpose, format))});
  }
  return formats;
}

void chooseItem(ExportPlan& plan, std::size_t item) {
  plan.item = item;
  plan.name = kItems[item].name + exportFormats(kItems[item]).front().ending;
}

std::string endingOf(const ExportPlan& plan) {
  std::string best;
  for (const ExportFormat& format : exportFormats(plan.what()))
    if (plan.name.ends_with(format.ending) && plan.name.size() > format.ending.size() &&
        format.ending.size() > best.size())
      best = format.ending;
  return best;
}

void chooseEnding(ExportPlan& plan, const std::string& ending) {
  const std::string old = endingOf(plan);
  if (!old.empty()) plan.name.resize(plan.name.size() - old.size());
  plan.name += ending;
}

bool placementChoosable(const ExportPlan& plan) {
  if (plan.what().purpose != FilePurpose::saveMesh || endingOf(plan).empty()) return false;
  return leavesPlacementOpen(*formatNamed(purposeText(plan.what().purpose).kind, plan.name));
}

std::string placementWords(const ExportPlan& plan) {
  switch (plan.what().purpose) {
    case FilePurpose::savePicture:
    case FilePurpose::saveTurntable:
      return {};
    case FilePurpose::saveScan:
    case FilePurpose::saveClassified:
    case FilePurpose::saveThinned:
    case FilePurpose::saveReport:
      return tr("Millimetres, in the frame of the scan's own file (LPS)");
    default:
      return endingOf(plan) == ".glb" ? tr("Metres, Y up, as the format has it")
                                      : tr("Millimetres, in the frame of the scan's own file (LPS)");
  }
}

std::vector<ExportFile> exportFiles(const ExportPlan& plan, const PictureFormat& pictures) {
  std::vector<ExportFile> files;
  std::error_code error;
  for (const fs::path& path : writtenFiles(plan.what().purpose, plan.path()))
    files.push_back({path.filename().string(), {}, fs::exists(path, error)});
  if (plan.what().purpose == FilePurpose::saveTurntable)
    files.front().more = fmt::format("{}_{:03}.png", fs::path(plan.name).stem().string(), pictures.views);
  return files;
}

namespace {

// Pictures of an earlier turntable are not mixed with those of another.
std::string takenText(const ExportPlan& plan) {
  if (plan.what().purpose != FilePurpose::saveTurntable) return {};
  const std::string taken = TurntableFiles::taken(plan.path());
  if (taken.empty()) return {};
  return fmt::format(fmt::runtime(tr("{} is there already; choose another name.")), taken);
}

}  // namespace

std::string complaintOf(const ExportPlan& plan, const Workspace& w) {
  if (!plan.what().available(w)) return tr(plan.what().missing);
  if (plan.name.empty() || plan.name.find('/') != std::string::npos)
    return tr("The file needs a name, without folders; type one.");
  std::error_code error;
  if (!fs::is_directory(plan.folder, error)) return tr("This folder does not exist; choose another one.");
  if (fs::is_directory(plan.path(), error)) return tr("A folder has this name; choose another one.");
  if (!endingOf(plan).empty()) return takenText(plan);
  std::string endings;
  for (const ExportFormat& format : exportFormats(plan.what()))
    endings += (endings.empty() ? "" : ", ") + format.ending;
  return fmt::format(fmt::runtime(tr("The name has no ending that can be written here; give it one of {}.")),
                     endings);
}

}  // namespace sonoskin::ui
