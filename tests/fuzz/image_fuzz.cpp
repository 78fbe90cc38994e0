// PNG pictures.
#include "core/io/image.h"
#include "tests/fuzz/fuzz_input.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("a.png");
  fuzz::attempt([&] {
    const Image image = readPng(file.hold({data, size}));
    fuzz::claim(image.rgba.size() == 4 * std::size_t(image.width) * std::size_t(image.height),
                "a picture has all of its pixels");
  });
  return 0;
}
