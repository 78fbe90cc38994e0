#include "core/io/dicom/dicom_tags.h"

#include <algorithm>
#include <array>

namespace sonoskin {
namespace {

struct Known {
  DicomTag tag;
  std::string_view type;
};

// In the order of their tags [DICOM PS3.6, 6; the sequences and their content: PS3.3].
constexpr auto kKnown = std::to_array<Known>({
    {tag::kTransferSyntax, "UI"},
    {tag::kDirectoryRecords, "SQ"},
    {tag::kReferencedFile, "CS"},
    {tag::kImageType, "CS"},
    {tag::kSopClass, "UI"},
    {tag::kSopInstance, "UI"},
    {tag::kAcquisitionTime, "TM"},
    {tag::kContentTime, "TM"},
    {tag::kModality, "CS"},
    {tag::kManufacturer, "LO"},
    {tag::kModelName, "LO"},
    {tag::kFrameType, "CS"},
    {tag::kCineRate, "IS"},
    {tag::kEchoTime, "DS"},
    {tag::kEchoNumber, "IS"},
    {tag::kSliceSpacing, "DS"},
    {tag::kTriggerTime, "DS"},
    {tag::kFrameTime, "DS"},
    {tag::kFrameTimes, "DS"},
    {tag::kImagerPixelSpacing, "DS"},
    {tag::kScannedPixelSpacing, "DS"},
    {tag::kRegions, "SQ"},
    {tag::kRegionFormat, "US"},
    {tag::kRegionData, "US"},
    {tag::kRegionMinX, "UL"},
    {tag::kRegionMinY, "UL"},
    {tag::kRegionMaxX, "UL"},
    {tag::kRegionMaxY, "UL"},
    {tag::kUnitsX, "US"},
    {tag::kUnitsY, "US"},
    {tag::kDeltaX, "FD"},
    {tag::kDeltaY, "FD"},
    {tag::kFrameAcquired, "DT"},
    {tag::kEffectiveEcho, "FD"},
    {tag::kDiffusionB, "FD"},
    {tag::kMrEcho, "SQ"},
    {tag::kMrDiffusion, "SQ"},
    {tag::kCardiacSync, "SQ"},
    {tag::kFrameReference, "DT"},
    {tag::kMrFrameType, "SQ"},
    {tag::kCtFrameType, "SQ"},
    {tag::kImageDataType, "SQ"},
    {tag::kDataType, "CS"},
    {tag::kSeries, "UI"},
    {tag::kAcquisition, "IS"},
    {tag::kInstance, "IS"},
    {tag::kPosition, "DS"},
    {tag::kOrientation, "DS"},
    {tag::kTemporal, "IS"},
    {tag::kStack, "SH"},
    {tag::kFrameContent, "SQ"},
    {tag::kPlanePosition, "SQ"},
    {tag::kPlaneOrientation, "SQ"},
    {tag::kTemporalIndex, "UL"},
    {tag::kTriggerDelay, "FD"},
    {tag::kFrameAcquisition, "US"},
    {tag::kDimensionValues, "UL"},
    {tag::kDimensionPointer, "AT"},
    {tag::kDimensions, "SQ"},
    {tag::kVolumePosition, "FD"},
    {tag::kVolumeOrientation, "FD"},
    {tag::kScanGeometry, "CS"},
    {tag::kApex, "FD"},
    {tag::kToTransducer, "FD"},
    {tag::kTemporalOffset, "FD"},
    {tag::kVolumePlanePosition, "SQ"},
    {tag::kVolumePlaneOrientation, "SQ"},
    {tag::kTemporalPosition, "SQ"},
    {tag::kOrganisation, "CS"},
    {tag::kSamples, "US"},
    {tag::kPhotometric, "CS"},
    {tag::kPlanar, "US"},
    {tag::kFrames, "IS"},
    {tag::kFrameIncrement, "AT"},
    {tag::kRows, "US"},
    {tag::kColumns, "US"},
    {tag::kPixelSpacing, "DS"},
    {tag::kAspectRatio, "IS"},
    {tag::kAllocated, "US"},
    {tag::kStored, "US"},
    {tag::kHighBit, "US"},
    {tag::kSigned, "US"},
    {tag::kPadding, "XS"},
    {tag::kPaddingLimit, "XS"},
    {tag::kBurnedIn, "CS"},
    {tag::kIntercept, "DS"},
    {tag::kSlope, "DS"},
    {tag::kPalette, "US"},
    {tag::kPalette + 1, "US"},
    {tag::kPalette + 2, "US"},
    {tag::kPaletteRed, "OW"},
    {tag::kPaletteRed + 1, "OW"},
    {tag::kPaletteRed + 2, "OW"},
    {tag::kSegmentedPalette, "OW"},
    {tag::kPixelMeasures, "SQ"},
    {tag::kPixelTransform, "SQ"},
    {tag::kDetectors, "SQ"},
    {tag::kFrameOffsets, "DS"},
    {tag::kSharedGroups, "SQ"},
    {tag::kFrameGroups, "SQ"},
    {tag::kFrameStarts, "OV"},
    {tag::kFloatPixels, "OF"},
    {tag::kDoublePixels, "OD"},
    {tag::kPixels, "OW"},
});
static_assert(std::ranges::is_sorted(kKnown, {}, &Known::tag));

// Block: a maker's name for it, the element's number in it, and what that is.
struct Block {
  std::string_view creator;
  DicomTag number;
  PrivateElement element;
};
constexpr auto kBlocks = std::to_array<Block>({
    {"Philips3D", 0x3001'0001, {tag::kPhilipsSlices, "UL"}},
    {"Philips3D", 0x3001'0002, {tag::kPhilipsUnitsZ, "US"}},
    {"Philips3D", 0x3001'0003, {tag::kPhilipsDeltaZ, "FD"}},
    {"Philips US Imaging DD 036", 0x200D'0001, {tag::kPhilipsDims, "LO"}},
    {"Philips US Imaging DD 036", 0x200D'0003, {tag::kPhilipsSpacing, "LO"}},
    {"Philips US Imaging DD 033", 0x200D'000B, {tag::kPhilipsVoxels, "OB"}},
    {"Philips US Imaging DD 045", 0x200D'00F8, {tag::kPhilipsNative, "UN"}},
    {"Eigen Artemis", 0x1129'0016, {tag::kEigenSpacing, "DS"}},
    {"Eigen, Inc", 0x1129'0016, {tag::kEigenSpacing, "DS"}},
    {"KRETZ_US", 0x7FE1'0001, {tag::kKretzFile, "OB"}},
    {"GEMS_Ultrasound_MovieGroup_001", 0x7FE1'0001, {tag::kMovieGroup, "UN"}},
});

}  // namespace

std::string_view dicomType(DicomTag tag) {
  const auto found = std::ranges::lower_bound(kKnown, tag, {}, &Known::tag);
  return found != kKnown.end() && found->tag == tag ? found->type : std::string_view();
}

PrivateElement privateElement(std::string_view creator, DicomTag tag) {
  const DicomTag number = tag & 0xFFFF'00FF;
  for (const Block& block : kBlocks)
    if (block.number == number && block.creator == creator) return block.element;
  return {};
}

bool reservesBlock(DicomTag tag) {
  const DicomTag element = tag & 0xFFFF;
  return element >= 0x10 && element <= 0xFF &&
         std::ranges::any_of(kBlocks, [&](const Block& b) { return b.number >> 16 == tag >> 16; });
}

}  // namespace sonoskin
