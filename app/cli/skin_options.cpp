#include "app/cli/skin_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>

#include "app/cli/choices.h"
#include "app/cli/output_file.h"
#include "core/base/error.h"

namespace sonoskin {
void addQualityOption(CLI::App& command, SkinQuality& quality) {
  const auto store = [&quality](const std::string& name) {
    if (name != "full" && name != "light")
      throw Error(fmt::format("--quality {} is not known; give full or light.", name), Error::Kind::usage);
    const bool own = quality.ownCoordinates;
    quality = name == "full" ? pictureQuality() : lightQuality();
    quality.ownCoordinates = own;
  };
  command
      .add_option_function<std::string>(
          "--quality", store,
          "for skin; full: every triangle and texels of 0.15 mm; light: 100,000 "
          "triangles and texels of 0.3 mm [default full]")
      ->type_name("full|light");
}

void addBakeOption(CLI::App& command, Bake& bake) {
  addEnum(command, "--bake", bake, 1,
          "the surface with its skin's maps for other programs (GLB and OBJ): colour, normals and roughness, "
          "or the "
          "light that comes out of the skin");
}

SkinPictureOptions SkinRenderOptions::picture() const {
  SkinPictureOptions drawn = look;
  if (reference) drawn.quality.diffusion = DiffusionMethod::reference;
  return drawn;
}

void addSkinLook(CLI::App& command, SkinRenderOptions& options) {
  addEnum(command, "--pass", options.look.pass, 0,
          fmt::format("for skin: one of the things that the picture is made of: {} [default skin]",
                      fmt::join(enumNames(SkinPass{}), ", ")));
  command.add_flag("--reference", options.reference,
                   "for skin: light is spread by integration over the surface, exact and slow");
  addQualityOption(command, options.look.quality);
}

void addSkinOptions(CLI::App& command, SkinRenderOptions& options) {
  addSkinLook(command, options);
  command.add_flag("--own-coordinates", options.look.quality.ownCoordinates,
                   "for skin: the map that a mesh file brings, where no two of its triangles lie over each "
                   "other; else one is made");
  addBakeOption(command, options.bake);
}

void checkSkinOptions(const SkinRenderOptions& options, const std::string& view, const std::string& out) {
  const auto onlyFor = [&](bool given, const char* name) {
    if (given && view != "skin")
      throw Error(fmt::format("{} is for --view skin, not {}; leave one of the two out.", name, view),
                  Error::Kind::usage);
  };
  onlyFor(options.look.pass != SkinPass::skin, "--pass");
  onlyFor(options.reference, "--reference");
  onlyFor(options.look.quality.ownCoordinates, "--own-coordinates");
  onlyFor(options.bake != Bake::none, "--bake");
  checkOutputFile(out, options.bake == Bake::none ? FileKind::picture : FileKind::texturedMesh);
}

}  // namespace sonoskin
