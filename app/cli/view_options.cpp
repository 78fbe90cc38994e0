#include "app/cli/view_options.h"

#include <fmt/format.h>

#include <vector>

#include "app/cli/choices.h"
#include "app/cli/finite.h"
#include "app/cli/volume_options.h"
#include "core/base/error.h"

namespace sonoskin {
namespace {

void addSliceOptions(CLI::App& command, ScanView& view) {
  addChoice(command, "--layer", view.layer, {"raw", "classified", "thinned"},
            "for slice and volume: which volume is shown; a slice is of the classified one by default, in "
            "volume the raw one; thinned: for slice alone");
  addChoice(command, "--plane", view.plane, {"axial", "sagittal", "coronal"},
            "for slice; of scans without a patient's directions the scanner's A, B and C");
  command
      .add_option_function<std::vector<double>>(
          "--at", [&view](const std::vector<double>& at) { view.at = glm::dvec3(at[0], at[1], at[2]); },
          "for slice and slices: a place that they go through, mm; the middle by default")
      ->delimiter(',')
      ->expected(3)
      ->check(finite())
      ->type_name("X,Y,Z");
}

void addFrameOptions(CLI::App& command, PictureOptions& picture) {
  command.add_flag_callback(
      "--mark-unmeasured", [&picture] { picture.unseenShade = 1; },
      "for skin and mesh: grey what was not measured: closed holes, and the border, where points grow "
      "sparse");
  command
      .add_option(
          "--camera", picture.camera,
          "probe, face, front, back, left, right, top, bottom or portrait, and changes to it: azimuth=, "
          "elevation=, roll= (degrees), zoom=; with commas [default probe]")
      ->type_name("WORDS");
  command
      .add_option("--light", picture.light,
                  "portrait, or azimuth=, elevation= (degrees from the camera), strength=; with commas; skin "
                  "has the lights of --light.* then, but for these [default portrait]")
      ->type_name("WORDS");
  command
      .add_option("--clip", picture.clip,
                  "cuts away what lies toward: camera, front, back, left, right, top or bottom; and at=, mm "
                  "from the middle toward it; with commas")
      ->type_name("WORDS");
}

}  // namespace

void addViewOptions(CLI::App& command, ScanView& view) {
  addChoice(command, "--view", view.view, {"skin", "mesh", "volume", "slices", "slice"},
            "skin: the surface as skin, with light that goes in and comes out; mesh: plain; volume: "
            "ray-cast; slices: raw, classified and thinned in three planes; slice: one of them");
  addSliceOptions(command, view);
  addVolumeOptions(command, view.volume);
  addFrameOptions(command, view.picture);
}

bool isPlanar(const ScanView& view) { return view.view == "slices" || view.view == "slice"; }

void checkViewOptions(const ScanView& view) {
  const Camera camera = parseCamera(view.picture.camera, {}, {}, 1);
  parseLighting(view.picture.light, camera);
  parseClip(view.picture.clip, camera, {});
  checkVolumeOptions(view.volume);
  const auto onlyFor = [&](bool given, const char* options, const char* views) {
    if (given)
      throw Error(fmt::format("{} does nothing with --view {}; it is for {}.", options, view.view, views),
                  Error::Kind::usage);
  };
  const bool layered = view.view == "slice" || view.view == "volume";
  onlyFor(!view.layer.empty() && !layered, "--layer", "slice and volume");
  onlyFor(view.layer == "thinned" && view.view == "volume", "--layer thinned", "slice");
  onlyFor(view.plane != "axial" && view.view != "slice", "--plane", "slice");
  onlyFor(view.at.has_value() && !isPlanar(view), "--at", "slice and slices");
  onlyFor(!view.picture.clip.empty() && isPlanar(view), "--clip", "skin, mesh and volume");
}

}  // namespace sonoskin
