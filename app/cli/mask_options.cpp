#include "app/cli/mask_options.h"

namespace sonoskin {

void addMaskOptions(CLI::App& command, InputFiles& files) {
  command
      .add_option("--mask", files.mask,
                  "volume of the same scan that is not zero where something was scanned; found from zero "
                  "padding by default")
      ->type_name("FILE");
  command
      .add_option("--erase", files.erased,
                  "volume of the same scan that is not zero where nothing counts, such as an arm before "
                  "the face")
      ->type_name("FILE");
}

}  // namespace sonoskin
