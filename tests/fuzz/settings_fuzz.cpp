// The window's settings: any file gives settings that can be used and written again.
#include "app/workspace/settings.h"

#include "tests/fuzz/fuzz_input.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("settings.json"), copy("copy.json");
  const Settings read = readSettings(file.hold({data, size}));
  fuzz::claim(read.width >= 800 && read.width <= 8192 && read.height >= 600 && read.height <= 8192,
              "the window has a size that screens have");
  const std::filesystem::path written = copy.hold({});
  writeSettings(written, read);
  const Settings again = readSettings(written);
  fuzz::claim(again.recent == read.recent && again.folder == read.folder && again.width == read.width &&
                  again.height == read.height && again.skinQuality == read.skinQuality &&
                  again.remembersFiles == read.remembersFiles,
              "settings read back the same");
  return 0;
}
