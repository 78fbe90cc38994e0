#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "app/batch/contact_sheet.h"
#include "app/cli/commands.h"
#include "app/cli/mask_options.h"
#include "app/cli/output_file.h"
#include "app/cli/parameter_options.h"
#include "app/cli/picture_options.h"
#include "app/cli/skin_options.h"
#include "app/cli/view_options.h"
#include "app/document/input.h"
#include "core/base/error.h"
#include "core/base/timer.h"
#include "core/io/file_formats.h"

namespace sonoskin {
namespace {

struct SheetOptions {
  InputFiles files;
  std::string out;
  std::vector<std::string> over;
  ScanView view;
  SkinRenderOptions skin;
  ParameterOptions parameters;
  gl::Backend backend = gl::Backend::egl;
};

constexpr double kLoaded = 0.1, kDrawn = 0.97;  // shares of the time

nlohmann::ordered_json axesJson(const std::vector<SheetAxis>& axes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const SheetAxis& axis : axes)
    list.push_back({{"parameter", axis.parameter}, {"symbol", axis.symbol}, {"values", axis.values}});
  return list;
}

nlohmann::ordered_json cellsJson(const ContactSheet& sheet, const std::vector<SheetAxis>& axes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t n = 0; n < sheet.cells.size(); ++n) {
    const SheetCell& cell = sheet.cells[n];
    nlohmann::ordered_json json;
    for (std::size_t a = 0; a < axes.size(); ++a) json["values"].push_back(axes[a].values[cell.values[a]]);
    const glm::ivec2 corner = sheet.layout.corner(n);
    json["corner"] = {corner.x, corner.y};
    json["current"] = cell.current;
    if (!cell.failure.empty()) json["failure"] = cell.failure;
    list.push_back(json);
  }
  return list;
}

// What was written, for people and programs.
void tell(const SheetOptions& options, const std::vector<SheetAxis>& axes, const ContactSheet& sheet,
          nlohmann::ordered_json json, Console& console) {
  const SheetLayout& layout = sheet.layout;
  json["file"] = inputName(options.out);
  json["view"] = options.view.view;
  json["over"] = axesJson(axes);
  json["size"] = {layout.size().x, layout.size().y};
  json["cell_size"] = {layout.cell.x, layout.cell.y};
  json["grid"] = {layout.grid.x, layout.grid.y};
  json["cells"] = cellsJson(sheet, axes);
  for (const StageReport& stage : sheet.stages)
    json["stages"].push_back({{"name", stage.name}, {"seconds", stage.seconds}, {"bytes", stage.bytes}});
  json["gl"] = gl::glInfo();
  json["warnings"] = console.warnings();
  console.print(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace),
                fmt::format("{}: {} pictures, {} x {} pixels", options.out, sheet.cells.size(),
                            layout.size().x, layout.size().y));
}

// Refuses, before any work, what cannot be done.
std::vector<SheetAxis> check(const SheetOptions& options, const Parameters& parameters) {
  checkOutputFile(options.out, FileKind::picture);
  const InputFiles& files = options.files;
  refuseInputs(options.out, {files.volume, files.mask, files.erased, options.parameters.recipeFile()});
  checkSkinOptions(options.skin, options.view.view, options.out);
  checkViewOptions(options.view);
  if (isMeshFile(files.volume))
    throw Error(
        fmt::format("A contact sheet is made of a volume, and {} is a mesh; give the volume.", files.volume),
        Error::Kind::usage);
  std::vector<SheetAxis> axes;
  for (const std::string& text : options.over) axes.push_back(sheetAxis(parameters, text));
  sheetLayout(axes, options.view.picture.size);
  return axes;
}

void sheet(SheetOptions& options, Console& console) {
  const Timer timer;
  const Parameters parameters =
      withLandmarks(options.parameters.resolve(options.files), options.files.volume);
  SheetOrder order{{}, parameters, check(options, parameters), options.view};
  order.view.skin = options.skin.picture();
  console.beginStage(options.files.volume == kPhantomInput ? "simulation" : "reading");
  order.scan = loadInput(options.files, parameters, console.progress().part(0, kLoaded));
  requireWithin(order.scan, order.view);
  noteTimeSteps(order.scan);
  const auto context = gl::makeOffscreenContext(options.backend);
  const ContactSheet made = makeSheet(*context, order, console.progress().part(kLoaded, kDrawn),
                                      [&](const std::string& cell) { console.beginStage(cell); });
  console.beginStage("sheet");
  writePng(options.out, pictureOfSheet(made));
  context->makeCurrent();  // what it is, is told
  nlohmann::ordered_json json;
  if (const std::string name = console.nameOf(options.files.volume); !name.empty()) json["input"] = name;
  json["seconds"] = timer.seconds();
  tell(options, order.axes, made, json, console);
}

}  // namespace

Command addSheetCommand(CLI::App& program, Console& console) {
  auto options = std::make_shared<SheetOptions>();
  options->view.picture.size = {320, 240};
  CLI::App* command = program.add_subcommand(
      "sheet", "contact sheet: the same picture for each value of one parameter, or each pair of two");
  command->add_option("INPUT", options->files.volume, "volume file, or \"phantom\" for the simulated scan")
      ->required()
      ->type_name("");
  command
      ->add_option("--out", options->out,
                   fmt::format("picture to write: {}", extensionList(FileKind::picture)))
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--over", options->over,
                   "a parameter and its values, as in beta=0.5,1,2; once or twice: the first goes to the "
                   "right, the second down")
      ->required()
      ->allow_extra_args(false)
      ->type_name("NAME=V,V,...");
  addMaskOptions(*command, options->files);
  addViewOptions(*command, options->view);
  addSkinLook(*command, options->skin);
  addSizeOption(*command, options->view.picture.size);
  addBackendOption(*command, options->backend);
  console.addThreads(*command);
  console.addJson(*command);
  console.addNameInput(*command);
  options->parameters.addTo(*command);
  return {command, [options, &console] { sheet(*options, console); }};
}

}  // namespace sonoskin
