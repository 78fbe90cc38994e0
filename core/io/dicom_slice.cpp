#include "core/io/dicom_slice.h"

#include <itkGDCMImageIO.h>
#include <itkMetaDataObject.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/io/dicom_lengths.h"
#include "core/io/header_text.h"
#include "core/io/itk_files.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

void guarded(const fs::path& path, const std::function<void()>& call) {
  callItk(call,
          fmt::format("{} holds no pixels that can be read: it is incomplete, or packed in a way that is "
                      "not known here; get a fresh copy, or save it as NRRD.",
                      path.string()));
}

}  // namespace

struct DicomSlice::Reader {
  itk::GDCMImageIO::Pointer io = itk::GDCMImageIO::New();
};

DicomSlice::~DicomSlice() = default;

DicomSlice::DicomSlice(const fs::path& path) : path_(path), reader_(std::make_unique<Reader>()) {
  checkDicomLengths(path);
  reader_->io->SetFileName(path.string());
  guarded(path, [&] { reader_->io->ReadImageInformation(); });
  stored_ = describedBy(*reader_->io, path);
  stored_.format = "DICOM series";
  stored_.modality = modality();
  stored_.spacingKnown = text("0028|0030") || text("0018|1164") || text("0018|2010");
  if (const auto range = padding()) stored_.padding = {*range};
}

glm::dvec3 DicomSlice::normal() const {
  return glm::cross(stored_.geometry.direction[0], stored_.geometry.direction[1]);
}

std::size_t DicomSlice::bytes() const {
  return stored_.geometry.voxels() * std::size_t(stored_.components) * numberTypeBytes(stored_.type);
}

void DicomSlice::read(std::uint8_t* out) {
  itk::ImageIORegion region(reader_->io->GetNumberOfDimensions());
  for (unsigned a = 0; a < reader_->io->GetNumberOfDimensions(); ++a)
    region.SetSize(a, reader_->io->GetDimensions(a));
  reader_->io->SetIORegion(region);
  require(std::size_t(reader_->io->GetImageSizeInBytes()) == bytes(),
          "{} has a damaged header; get a fresh copy.", path_.string());
  guarded(path_, [&] { reader_->io->Read(out); });
}

std::optional<std::string> DicomSlice::text(const char* tag) const {
  std::string found;
  if (!itk::ExposeMetaData(reader_->io->GetMetaDataDictionary(), tag, found)) return {};
  std::erase(found, '\0');
  return std::string(trimmed(found));
}

std::optional<int> DicomSlice::number(const char* tag) const {
  const auto found = text(tag);
  return found ? parseNumber<int>(*found) : std::nullopt;
}

// Two capital letters by the standard; whatever else a file puts there is not passed on.
std::string DicomSlice::modality() const {
  const std::string word = text("0008|0060").value_or("");
  const bool isCode =
      word.size() == 2 && std::ranges::all_of(word, [](char c) { return c >= 'A' && c <= 'Z'; });
  return isCode ? word : std::string();
}

// Value and limit are bits like the pixels' own: whether they are negative is said by the pixels' representation,
// whatever type the elements have. Where white is 0, the library turns the pixels, and so they are turned too.
std::optional<Padding> DicomSlice::padding() const {
  const auto value = number("0028|0120");
  if (!value || stored_.components != 1) return {};
  const bool isSigned = number("0028|0103").value_or(0) == 1;
  const bool isTurned = text("0028|0004") == "MONOCHROME1";
  const int white = (1 << std::clamp(number("0028|0101").value_or(16), 1, 16)) - 1;
  const auto scaled = [&](int given) {
    const int bits = isTurned ? white - std::min(given & 0xffff, white) : given;
    const double pixel = isSigned ? double(std::int16_t(bits)) : double(std::uint16_t(bits));
    return float(reader_->io->GetRescaleSlope() * pixel + reader_->io->GetRescaleIntercept());
  };
  const float a = scaled(*value), b = scaled(number("0028|0121").value_or(*value));
  return Padding{std::min(a, b), std::max(a, b)};
}

}  // namespace sonoskin
