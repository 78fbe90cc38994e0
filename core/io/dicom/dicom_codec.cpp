#include "core/io/dicom/dicom_codec.h"

#include <gdcmBitmap.h>
#include <gdcmFragment.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmTrace.h>

#include "core/base/error.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

gdcm::DataElement elementOf(const std::vector<std::uint8_t>& packed) {
  gdcm::Fragment fragment;
  fragment.SetByteValue(reinterpret_cast<const char*>(packed.data()), gdcm::VL(std::uint32_t(packed.size())));
  const gdcm::SmartPointer<gdcm::SequenceOfFragments> fragments = new gdcm::SequenceOfFragments;
  fragments->AddFragment(fragment);
  gdcm::DataElement element(gdcm::Tag(0x7FE0, 0x0010), gdcm::VL(0xFFFFFFFF), gdcm::VR::OB);
  element.SetValue(*fragments);
  return element;
}

// Called RGB, colours are left as they lie in the stream.
gdcm::Bitmap bitmapOf(const DicomPixels& p, const gdcm::TransferSyntax& syntax) {
  gdcm::Bitmap bitmap;
  bitmap.SetTransferSyntax(syntax);
  bitmap.SetNumberOfDimensions(2);
  bitmap.SetDimension(0, unsigned(p.columns));
  bitmap.SetDimension(1, unsigned(p.rows));
  bitmap.SetPixelFormat(gdcm::PixelFormat(std::uint16_t(p.samples), std::uint16_t(p.allocated),
                                          std::uint16_t(p.stored), std::uint16_t(p.highBit),
                                          std::uint16_t(p.isSigned)));
  using Colour = gdcm::PhotometricInterpretation;
  bitmap.SetPhotometricInterpretation(p.samples == 3 ? Colour::RGB : Colour::MONOCHROME2);
  return bitmap;
}

}  // namespace

std::vector<std::uint8_t> unpackFrame(const DicomPixels& p, const std::vector<std::uint8_t>& packed,
                                      const fs::path& path) {
  // Its messages may quote the file, and would go to the terminal.
  gdcm::Trace::DebugOff(), gdcm::Trace::WarningOff(), gdcm::Trace::ErrorOff();
  const gdcm::TransferSyntax syntax(gdcm::TransferSyntax::GetTSType(p.syntax.c_str()));
  std::vector<std::uint8_t> frame(p.frameBytes());
  bool unpacked = false;
  try {
    gdcm::Bitmap bitmap = bitmapOf(p, syntax);
    bitmap.SetDataElement(elementOf(packed));
    unpacked = syntax.IsEncapsulated() && std::uint64_t(bitmap.GetBufferLength()) == frame.size() &&
               bitmap.GetBuffer(reinterpret_cast<char*>(frame.data()));
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
  }
  require(unpacked,
          "{} holds no pixels that can be read: it is damaged, or packed in a way that is not known here; "
          "get a fresh copy, or save it unpacked.",
          path.string());
  return frame;
}

}  // namespace sonoskin
