// The command that repeats an export.
#include <fmt/format.h>

#include "app/document/command_text.h"
#include "app/panels/export_plan.h"

namespace sonoskin::ui {
namespace {

std::string inputOf(const Session& session) {
  return session.isPhantom() ? "phantom" : session.source().string();
}

std::string recipeOf(const ExportPlan& plan) {
  return std::filesystem::path(plan.path()).replace_extension(".recipe.json").string();
}

std::string withoutDot(const std::string& ending) {
  return ending.substr(std::min<std::size_t>(1, ending.size()));
}

template <class E>
std::string word(E value) {
  return enumNames(value)[std::size_t(value)];
}

// What `run` writes into a folder of its own.
std::string runCommand(const ExportPlan& plan, const Workspace& w) {
  CommandText command("run");
  command.word(inputOf(w.session));
  command.option("--out", (plan.folder / std::filesystem::path(plan.name).stem()).string());
  command.option("--recipe", plan.what().purpose == FilePurpose::saveReport && !w.sessionFile.empty()
                                 ? w.sessionFile.string()
                                 : recipeOf(plan));
  const std::string ending = withoutDot(endingOf(plan));
  switch (plan.what().purpose) {
    case FilePurpose::saveMesh:
      command.option("--export", ending);
      if (placementChoosable(plan) && plan.placement.frame != MeshFrame::lps)
        command.option("--mesh-frame", word(plan.placement.frame));
      if (placementChoosable(plan) && plan.placement.unit != MeshUnit::millimetres)
        command.option("--mesh-unit", word(plan.placement.unit));
      break;
    case FilePurpose::saveSkin:
      command.option("--export", ending).option("--bake", "colour");
      break;
    case FilePurpose::savePrint:
      if (ending != "stl") command.option("--export", ending);
      break;
    case FilePurpose::savePoints:
    case FilePurpose::saveScan:
    case FilePurpose::saveClassified:
    case FilePurpose::saveThinned:
      command.option("--keep", plan.what().id);
      if (plan.what().purpose != FilePurpose::savePoints && ending != "nrrd")
        command.option("--keep-as", ending);
      break;
    default:
      break;
  }
  return command.text();
}

// What the 3D view shows, as `render` has it.
std::string renderCommand(const ExportPlan& plan, const Workspace& w) {
  const ViewState& view = w.view;
  CommandText command("render");
  command.word(inputOf(w.session)).option("--out", plan.path().string()).option("--recipe", recipeOf(plan));
  if (view.content == SpaceContent::mesh && w.session.results().mesh) {
    command.option("--view", view.meshStyle == MeshStyle::skin ? "skin" : "mesh");
  } else {
    command.option("--view", "volume")
        .option("--layer", view.volumeLayer == VolumeLayer::raw ? "raw" : "classified");
    command.option("--mode", view.volumeStyle == VolumeStyle::surface       ? "iso"
                             : view.volumeStyle == VolumeStyle::translucent ? "dvr"
                                                                            : "mip");
    command.option("--level", fmt::format("{:.3f}", shownLevel(view, w.session.results())));
    if (!view.crop) command.flag("--whole");
  }
  command.option("--camera", cameraWords(view.camera));
  command.option("--size", fmt::format("{}x{}", w.pictureFormat.size[0], w.pictureFormat.size[1]));
  if (w.pictureFormat.transparent) command.flag("--transparent");
  if (plan.what().purpose == FilePurpose::saveTurntable)
    command.option("--turntable", std::to_string(w.pictureFormat.views));
  return command.text();
}

}  // namespace

std::string exportCommand(const ExportPlan& plan, const Workspace& w) {
  const FilePurpose purpose = plan.what().purpose;
  const bool picture = purpose == FilePurpose::savePicture || purpose == FilePurpose::saveTurntable;
  return picture ? renderCommand(plan, w) : runCommand(plan, w);
}

}  // namespace sonoskin::ui
