#include "app/cli/volume_options.h"

#include <fmt/format.h>

#include "app/cli/choices.h"
#include "app/cli/finite.h"
#include "core/base/error.h"
#include "render/transfer_presets.h"

namespace sonoskin {
namespace {

std::string presetNames() {
  std::string names;
  for (const TransferPreset& preset : transferPresets()) names += std::string(preset.name) + ", ";
  return names;
}

}  // namespace

void checkVolumeOptions(const VolumeShown& shown) {
  if (shown.mode != "dvr" && (shown.transfer != "amber" || !shown.shadows || shown.withMesh))
    throw Error("--transfer, --no-shadows and --with-mesh do nothing here; give --mode dvr with them.",
                Error::Kind::usage);
  lookOf(shown, 0.5f);
}

void addVolumeOptions(CLI::App& command, VolumeShown& shown) {
  addChoice(command, "--mode", shown.mode, {"iso", "dvr", "mip"},
            "for volume; iso: the first hit, dvr: translucent, mip: the largest value along each ray");
  command
      .add_option("--level", shown.level,
                  "for volume: grey of the skin's border, 0.001 .. 0.999; found from the volume by default")
      ->type_name("NUMBER")
      ->check(finite())
      ->check(CLI::Range(0.001, 0.999).description(""));
  command.add_flag("--whole", shown.whole,
                   "for volume: the whole region; by default only the box around the surface that was found");
  command
      .add_option("--transfer", shown.transfer,
                  fmt::format("for dvr: colour and opacity of each grey: {}or a file that the window saved "
                              "[default amber]",
                              presetNames()))
      ->type_name("NAME|FILE");
  command.add_flag_callback(
      "--no-shadows", [&shown] { shown.shadows = false; }, "for dvr: the key light reaches every place");
  command.add_flag("--with-mesh", shown.withMesh, "for dvr: the surface that was found, within the volume");
}

}  // namespace sonoskin
