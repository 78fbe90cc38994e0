#include "app/cli/mask_option.h"

namespace sonoskin {

void addMaskOption(CLI::App& command, std::string& mask) {
  command
      .add_option(
          "--mask", mask,
          "volume of the same dimensions that is not zero where something was scanned; found from zero "
          "padding by default")
      ->type_name("FILE");
}

}  // namespace sonoskin
