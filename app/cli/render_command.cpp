#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "app/batch/turntable_files.h"
#include "app/cli/choices.h"
#include "app/cli/commands.h"
#include "app/cli/mask_options.h"
#include "app/cli/parameter_options.h"
#include "app/cli/picture_options.h"
#include "app/cli/skin_options.h"
#include "app/cli/volume_options.h"
#include "app/document/face_view.h"
#include "app/document/input.h"
#include "app/document/view_planes.h"
#include "core/base/error.h"
#include "core/base/timer.h"
#include "core/io/file_formats.h"
#include "core/io/image.h"
#include "core/io/mesh_reader.h"
#include "core/mesh/facts/mesh_doubts.h"
#include "core/pipeline/face_use.h"
#include "core/pipeline/pipeline.h"
#include "render/pictures.h"
#include "render/skin/baked_maps.h"
#include "render/skin/skin_pictures.h"

namespace sonoskin {
namespace {

struct RenderOptions {
  InputFiles files;  // or a mesh
  std::string out;
  std::string view = "skin";
  VolumeRenderOptions volume;
  int turntable = 0;  // pictures; 0: one, from the camera
  float scale = 1;    // of a mesh
  bool flip = false;
  PictureOptions picture;
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
RenderOutput showMesh(const RenderOptions& o, const Parameters& parameters, gl::Context& context,
                      std::shared_ptr<const Mesh> mesh, Console& console) {
  const Progress progress = console.progress().part(kComputed, 1);
  if (o.skin.bake != Bake::none) {
    console.beginStage("maps");
    const BakeOptions bake{o.skin.look.quality, o.skin.bake == Bake::light};
    return {{}, bakeSkin(context, std::move(mesh), parameters, bake, o.picture, progress)};
  }
  console.beginStage("picture");
  if (o.view == "mesh") return {pictureOfMesh(context, std::move(mesh), MeshLook::clay, o.picture)};
  return {pictureOfSkin(context, std::move(mesh), parameters, o.skin.picture(), o.picture, progress)};
}

RenderOutput showMeshFile(RenderOptions& o, const Parameters& parameters, gl::Context& context,
                          Console& console) {
  if (o.view != "skin" && o.view != "mesh") {
    throw Error(
        fmt::format("--view {} is for volumes, and {} is a mesh; give skin or mesh.", o.view, o.files.volume),
        Error::Kind::usage);
  }
  console.beginStage("reading");
  Mesh read = readMesh(o.files.volume, console.progress().part(0, kComputed));
  if (o.scale != 1) scaleMesh(read, o.scale);
  if (o.flip) flipMesh(read);
  console.warn(meshDoubts(read));
  const auto mesh = std::make_shared<const Mesh>(std::move(read));
  // A mesh file does not tell where the probe was: the options do, for the axes of the world.
  Scan axes;
  axes.volume = std::make_shared<const Volume<float>>();
  o.picture.beam = beamOf(axes, parameters.scan);
  return showMesh(o, parameters, context, mesh, console);
}

RenderOutput showVolumeFile(RenderOptions& o, const Parameters& parameters, gl::Context& context,
                            Console& console) {
  if (o.scale != 1 || o.flip)
    throw Error("--scale and --flip are for meshes; of a volume correct the spacing in its header.",
                Error::Kind::usage);
  console.beginStage(o.files.volume == kPhantomInput ? "simulation" : "reading");
  Scan scan = loadInput(o.files, parameters, console.progress().part(0, kLoaded));
  noteTimeSteps(scan);
  o.picture.beam = beamOf(scan, parameters.scan);
  const auto compute = [&](Goal goal) {
    Results results = Pipeline().run(scan, parameters, goal, console.progress().part(kLoaded, kComputed),
                                     [&](const std::string& stage) { console.beginStage(stage); });
    console.warn(results.warnings);
    return results;
  };
  const Region region = regionOf(scan, parameters.region);
  if (o.view == "volume") {
    // Nothing is computed that the picture does not need: a level is found without a surface, a box around it is not.
    const VolumeRenderOptions& v = o.volume;
    const bool needsMesh = !v.whole || v.withMesh;
    const Results results =
        needsMesh || v.level <= 0 ? compute(needsMesh ? Goal::mesh : Goal::levels) : Results{};
    VolumePictureOptions look = v.picture(float(v.level > 0 ? v.level : results.visibleLevel));
    if (!v.whole) look.crop = boxAround(*results.mesh);
    if (v.withMesh) look.mesh = results.mesh;
    console.beginStage("picture");
    return {pictureOfVolume(context, withinRegion(std::exchange(scan.volume, {}), region), look, o.picture)};
  }
  const Results results = compute(Goal::mesh);
  if (o.view != "slices") {
    const FaceFit* face = isCertain(results.face.get(), parameters.face) ? results.face.get() : nullptr;
    const float aspect = float(o.picture.size.x) / float(o.picture.size.y);
    o.picture.face = cameraOnFace(results.mesh->positions, face, o.picture.beam, aspect);
    Parameters found = parameters;
    found.landmarks = landmarksWithFace(parameters, face);
    return showMesh(o, found, context, results.mesh, console);
  }
  console.beginStage("picture");
  const PlaneAxes planes = planeAxes(scan.volume->geometry, viewFrameOf(scan, o.picture.beam));
  return {pictureOfSlices(
      context, {scan.volume, results.classified, results.thinned, middleOf(*results.mesh), region, planes},
      o.picture.size)};
}

// Refuses bad words and what does not go together before any work.
void check(const RenderOptions& o) {
  checkSkinOptions(o.skin, o.view, o.out);
  const Camera camera = parseCamera(o.picture.camera, {}, {}, 1);
  parseLighting(o.picture.light, camera);
  parseClip(o.picture.clip, camera, {});
  checkVolumeOptions(o.volume);
  const bool planar = o.view == "slices" || o.skin.bake != Bake::none;
  if (planar && (o.turntable > 0 || !o.picture.background || !o.picture.clip.empty()))
    throw Error(
        "--turntable, --transparent and --clip do nothing here; they are for pictures of skin, mesh and "
        "volume.",
        Error::Kind::usage);
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
  json["view"] = options.view;
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
  const Parameters parameters =
      withLandmarks(options.parameters.resolve(options.files.recipe), options.files.volume);
  std::optional<TurntableFiles> around;
  if (options.turntable > 0) {
    around.emplace(options.out, options.turntable);
    options.picture.turntable = {options.turntable, [&around, &console](int view, Image picture) {
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
  const glm::ivec2 size = around ? options.picture.size : glm::ivec2(picture.width, picture.height);
  tell(options, around ? around->names() : std::vector<std::string>{}, size, timer.seconds(), console);
}

// What of it is seen, and on what ground.
void addFrameOptions(CLI::App& command, RenderOptions& options) {
  command
      .add_option("--clip", options.picture.clip,
                  "cuts away what lies toward: camera, front, back, left, right, top or bottom; and at=, mm "
                  "from the middle toward it; with commas")
      ->type_name("WORDS");
  command.add_flag_callback(
      "--transparent", [&options] { options.picture.background = false; }, "a picture without a background");
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
  addChoice(*command, "--view", options->view, {"skin", "mesh", "volume", "slices"},
            "skin: the surface as skin, with light that goes in and comes out; mesh: plain; volume: "
            "ray-cast; slices: "
            "raw, classified and thinned");
  addVolumeOptions(*command, options->volume);
  command
      ->add_option("--scale", options->scale,
                   "for a mesh in another unit than mm: 1000 for metres [default 1]")
      ->type_name("NUMBER")
      ->check(CLI::Range(1e-6, 1e6).description(""));
  command->add_flag("--flip", options->flip, "for a mesh that is inside out");
  command->add_flag_callback(
      "--mark-unmeasured", [options] { options->picture.unseenShade = 1; },
      "for skin and mesh: grey what was not measured: closed holes, and the border, where points grow "
      "sparse");
  command
      ->add_option(
          "--camera", options->picture.camera,
          "probe, face, front, back, left, right, top, bottom or portrait, and changes to it: azimuth=, "
          "elevation=, roll= (degrees), zoom=; with commas [default probe]")
      ->type_name("WORDS");
  command
      ->add_option(
          "--light", options->picture.light,
          "portrait, or azimuth=, elevation= (degrees from the camera), strength=; with commas; skin "
          "has the lights of --light.* then, but for these [default portrait]")
      ->type_name("WORDS");
  addFrameOptions(*command, *options);
  addSkinOptions(*command, options->skin);
  addSizeOption(*command, options->picture.size);
  addBackendOption(*command, options->backend);
  console.addThreads(*command);
  console.addJson(*command);
  console.addNameInput(*command);
  options->parameters.addTo(*command);
  return {command, [options, &console] { render(*options, console); }};
}

}  // namespace sonoskin
