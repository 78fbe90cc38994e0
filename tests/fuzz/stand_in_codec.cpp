// In the place of core/io/dicom/dicom_codec.cpp: what GDCM makes of packed pixels is not looked for here.
#include "core/base/error.h"
#include "core/io/dicom/dicom_codec.h"

namespace sonoskin {

std::vector<std::uint8_t> unpackFrame(const DicomPixels& pixels, const std::vector<std::uint8_t>& packed,
                                      const std::filesystem::path& path) {
  require(!packed.empty(), "{} holds no pixels that can be read; get a fresh copy.", path.string());
  return std::vector<std::uint8_t>(pixels.frameBytes(), packed.front());
}

}  // namespace sonoskin
