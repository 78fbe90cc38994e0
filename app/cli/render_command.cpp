#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "app/batch/scan_view.h"
#include "app/batch/turntable_files.h"
#include "app/cli/commands.h"
#include "app/cli/finite.h"
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
#include "core/io/image.h"
#include "core/io/mesh_reader.h"
#include "core/mesh/facts/mesh_doubts.h"
#include "core/pipeline/pipeline.h"
#include "render/skin/baked_maps.h"

namespace sonoskin {
namespace {

struct RenderOptions {
  InputFiles files;  // or a mesh
  std::string out;
  ScanView view;
  int turntable = 0;  // pictures; 0: one, from the camera
  float scale = 1;    // of a mesh
  bool flip = false;
  gl::Backend backend = gl::Backend::egl;
  ParameterOptions parameters;
  SkinRenderOptions skin;
};

// RenderOutput: what is written: a picture, or a surface with the maps of its skin.
struct RenderOutput {
  Image picture;
  std::optional<TexturedMesh> baked{};
};

// Shares of the time of what comes before the picture.
constexpr double kLoaded = 0.3, kComputed = 0.9;

// The surface, as the view says.
RenderOutput showSurface(const RenderOptions& o, const SurfaceShot& shot, gl::Context& context,
                         Console& console) {
  const Progress progress = console.progress().part(kComputed, 1);
  if (o.skin.bake == Bake::none) {
    console.beginStage("picture");
    return {pictureOfSurface(context, shot, progress)};
  }
  console.beginStage("maps");
  const BakeOptions bake{o.skin.look.quality, o.skin.bake == Bake::light};
  return {{}, bakeSkin(context, shot.mesh, shot.parameters, bake, shot.view.picture, progress)};
}

RenderOutput showMeshFile(const RenderOptions& o, const Parameters& parameters, gl::Context& context,
                          Console& console) {
  if (o.view.view != "skin" && o.view.view != "mesh") {
    throw Error(fmt::format("--view {} is for volumes, and {} is a mesh; give skin or mesh.", o.view.view,
                            o.files.volume),
                Error::Kind::usage);
  }
  console.beginStage("reading");
  Mesh read = readMesh(o.files.volume, console.progress().part(0, kComputed));
  if (o.scale != 1) scaleMesh(read, o.scale);
  if (o.flip) flipMesh(read);
  console.warn(meshDoubts(read));
  SurfaceShot shot{std::make_shared<const Mesh>(std::move(read)), parameters, o.view};
  // A mesh file does not tell where the probe was: the options do, for the axes of the world.
  Scan axes;
  axes.volume = std::make_shared<const Volume<float>>();
  shot.view.picture.beam = beamOf(axes, parameters.scan);
  return showSurface(o, shot, context, console);
}

// Nothing is computed that the picture does not need.
RenderOutput showVolumeFile(const RenderOptions& o, const Parameters& parameters, gl::Context& context,
                            Console& console) {
  if (o.scale != 1 || o.flip)
    throw Error("--scale and --flip are for meshes; of a volume correct the spacing in its header.",
                Error::Kind::usage);
  console.beginStage(o.files.volume == kPhantomInput ? "simulation" : "reading");
  ScanMade made{loadInput(o.files, parameters, console.progress().part(0, kLoaded)), {}, parameters};
  requireWithin(made.scan, o.view);
  noteTimeSteps(made.scan);
  if (const auto goal = goalOf(o.view)) {
    made.results = Pipeline().run(made.scan, parameters, *goal, console.progress().part(kLoaded, kComputed),
                                  [&](const std::string& stage) { console.beginStage(stage); });
    console.warn(made.results.warnings);
  }
  if (o.skin.bake != Bake::none) return showSurface(o, surfaceShot(made, o.view), context, console);
  console.beginStage("picture");
  return {pictureOfScan(context, std::move(made), o.view, console.progress().part(kComputed, 1))};
}

// Refuses bad words and what does not go together before any work.
void check(const RenderOptions& o) {
  checkSkinOptions(o.skin, o.view.view, o.out);
  refuseInputs(o.out, {o.files.volume, o.files.mask, o.files.erased, o.parameters.recipeFile()});
  const PictureOptions& picture = o.view.picture;
  const bool planar = isPlanar(o.view) || o.skin.bake != Bake::none;
  if (planar && (o.turntable > 0 || !picture.background || !picture.clip.empty()))
    throw Error(
        "--turntable, --transparent and --clip do nothing here; they are for pictures of skin, mesh and "
        "volume.",
        Error::Kind::usage);
  checkViewOptions(o.view);
}

// What was written, for people and programs.
void tell(const RenderOptions& options, const std::vector<std::string>& files, const glm::ivec2& size,
          double seconds, Console& console) {
  nlohmann::ordered_json json;
  if (const std::string name = console.nameOf(options.files.volume); !name.empty()) json["input"] = name;
  if (options.turntable > 0)
    json["files"] = files;
  else
    json["file"] = inputName(options.out);
  json["view"] = options.view.view;
  json["size"] = {size.x, size.y};
  json["gl"] = gl::glInfo();
  json["warnings"] = console.warnings();
  json["seconds"] = seconds;
  const std::string what = files.empty() ? options.out : fmt::format("{} to {}", files.front(), files.back());
  console.print(json.dump(2), fmt::format("{}: {} x {} pixels, {}", what, size.x, size.y, gl::glInfo()));
}

void render(RenderOptions& options, Console& console) {
  const Timer timer;
  check(options);
  options.view.skin = options.skin.picture();
  const Parameters parameters =
      withLandmarks(options.parameters.resolve(options.files), options.files.volume);
  std::optional<TurntableFiles> around;
  if (options.turntable > 0) {
    around.emplace(options.out, options.turntable);
    options.view.picture.turntable = {options.turntable, [&around, &console](int view, Image picture) {
                                        console.progress().throwIfCancelled();
                                        around->write(view, std::move(picture));
                                      }};
  }
  const auto context = gl::makeOffscreenContext(options.backend);
  const RenderOutput made = isMeshFile(options.files.volume)
                                ? showMeshFile(options, parameters, *context, console)
                                : showVolumeFile(options, parameters, *context, console);
  console.progress().throwIfCancelled();
  if (made.baked) {
    writeTexturedMesh(options.out, *made.baked);
  } else if (around) {
    around->finish(console.progress().cancelOnly());
  } else {
    writePng(options.out, made.picture);
  }
  const Image& picture = made.baked ? made.baked->colour : made.picture;
  const glm::ivec2 size = around ? options.view.picture.size : glm::ivec2(picture.width, picture.height);
  tell(options, around ? around->names() : std::vector<std::string>{}, size, timer.seconds(), console);
}

// On what ground, and how many.
void addPictureOptions(CLI::App& command, RenderOptions& options) {
  command.add_flag_callback(
      "--transparent", [&options] { options.view.picture.background = false; },
      "a picture without a background");
  command
      .add_option("--turntable", options.turntable,
                  "that many pictures all around, --out face.png gives face_001.png and so on, and as a film "
                  "face.mp4 where ffmpeg is installed")
      ->type_name("NUMBER")
      ->check(CLI::Range(2, kMostViews).description(""));
}

}  // namespace

Command addRenderCommand(CLI::App& program, Console& console) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = program.add_subcommand("render", "one picture of a volume or a mesh");
  command->add_option("FILE", options->files.volume, "volume or mesh file, or \"phantom\"")
      ->required()
      ->type_name("");
  command
      ->add_option("--out", options->out,
                   fmt::format("picture to write: {}; with --bake a surface: {}",
                               extensionList(FileKind::picture), extensionList(FileKind::texturedMesh)))
      ->required()
      ->type_name("FILE");
  addMaskOptions(*command, options->files);
  addViewOptions(*command, options->view);
  command
      ->add_option("--scale", options->scale,
                   "for a mesh in another unit than mm: 1000 for metres [default 1]")
      ->type_name("NUMBER")
      ->check(finite())
      ->check(CLI::Range(1e-6, 1e6).description(""));
  command->add_flag("--flip", options->flip, "for a mesh that is inside out");
  addPictureOptions(*command, *options);
  addSkinOptions(*command, options->skin);
  addSizeOption(*command, options->view.picture.size);
  addBackendOption(*command, options->backend);
  console.addThreads(*command);
  console.addJson(*command);
  console.addNameInput(*command);
  options->parameters.addTo(*command);
  return {command, [options, &console] { render(*options, console); }};
}

}  // namespace sonoskin
