#include "app/cli/volume_options.h"

#include <fmt/format.h>

#include "app/cli/choices.h"
#include "app/document/transfer_file.h"
#include "core/base/error.h"

namespace sonoskin {
namespace {

VolumeLook lookNamed(const std::string& mode) {
  return mode == "iso" ? VolumeLook::surface : mode == "mip" ? VolumeLook::maximum : VolumeLook::translucent;
}

std::string presetNames() {
  std::string names;
  for (const TransferPreset& preset : transferPresets()) names += std::string(preset.name) + ", ";
  return names;
}

// A preset of that name, else a file.
TransferFunction transferNamed(const std::string& name, float border) {
  if (const TransferPreset* preset = findTransferPreset(name)) return preset->at(border);
  return readTransfer(name).at(border);
}

}  // namespace

VolumePictureOptions VolumeRenderOptions::picture(float border) const {
  VolumePictureOptions look;
  look.look = lookNamed(mode);
  look.iso = border;
  if (look.look == VolumeLook::translucent) look.transfer = transferNamed(transfer, border);
  if (look.look == VolumeLook::maximum) look.smoothing = 0;
  look.shadows = shadows;
  return look;
}

void checkVolumeOptions(const VolumeRenderOptions& options) {
  if (options.mode != "dvr" && (options.transfer != "amber" || !options.shadows || options.withMesh))
    throw Error("--transfer, --no-shadows and --with-mesh do nothing here; give --mode dvr with them.",
                Error::Kind::usage);
  transferNamed(options.transfer, 0.5f);
}

void addVolumeOptions(CLI::App& command, VolumeRenderOptions& options) {
  addChoice(command, "--mode", options.mode, {"iso", "dvr", "mip"},
            "for volume; iso: the first hit, dvr: translucent, mip: the largest value along each ray");
  command
      .add_option("--level", options.level,
                  "for volume: grey of the skin's border, 0 .. 1; found from the volume by default")
      ->type_name("NUMBER")
      ->check(CLI::Range(0.001, 0.999).description(""));
  command.add_flag("--whole", options.whole,
                   "for volume: the whole region; by default only the box around the surface that was found");
  command
      .add_option("--transfer", options.transfer,
                  fmt::format("for dvr: colour and opacity of each grey: {}or a file that the window saved "
                              "[default amber]",
                              presetNames()))
      ->type_name("NAME|FILE");
  command.add_flag_callback(
      "--no-shadows", [&options] { options.shadows = false; }, "for dvr: the key light reaches every place");
  command.add_flag("--with-mesh", options.withMesh, "for dvr: the surface that was found, within the volume");
}

}  // namespace sonoskin
