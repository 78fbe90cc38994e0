#pragma once

#include <cstdint>
#include <string_view>

// The elements that are taken from a DICOM file. All others are passed over where they lie, so that what names a
// patient never gets into this program.
namespace sonoskin {

using DicomTag = std::uint32_t;  // group and element, each half of it

namespace tag {
inline constexpr DicomTag kTransferSyntax = 0x0002'0010;
inline constexpr DicomTag kDirectoryRecords = 0x0004'1220, kReferencedFile = 0x0004'1500;
inline constexpr DicomTag kImageType = 0x0008'0008, kSopClass = 0x0008'0016, kSopInstance = 0x0008'0018,
                          kAcquisitionTime = 0x0008'0032, kContentTime = 0x0008'0033, kModality = 0x0008'0060,
                          kManufacturer = 0x0008'0070, kModelName = 0x0008'1090, kFrameType = 0x0008'9007;
inline constexpr DicomTag kCineRate = 0x0018'0040, kEchoTime = 0x0018'0081, kEchoNumber = 0x0018'0086,
                          kSliceSpacing = 0x0018'0088, kTriggerTime = 0x0018'1060, kFrameTime = 0x0018'1063,
                          kFrameTimes = 0x0018'1065, kImagerPixelSpacing = 0x0018'1164,
                          kScannedPixelSpacing = 0x0018'2010, kRegions = 0x0018'6011,
                          kRegionFormat = 0x0018'6012, kRegionData = 0x0018'6014, kRegionMinX = 0x0018'6018,
                          kRegionMinY = 0x0018'601A, kRegionMaxX = 0x0018'601C, kRegionMaxY = 0x0018'601E,
                          kUnitsX = 0x0018'6024, kUnitsY = 0x0018'6026, kDeltaX = 0x0018'602C,
                          kDeltaY = 0x0018'602E, kFrameAcquired = 0x0018'9074, kEffectiveEcho = 0x0018'9082,
                          kDiffusionB = 0x0018'9087, kMrEcho = 0x0018'9114, kMrDiffusion = 0x0018'9117,
                          kCardiacSync = 0x0018'9118, kFrameReference = 0x0018'9151,
                          kMrFrameType = 0x0018'9226, kCtFrameType = 0x0018'9329,
                          kImageDataType = 0x0018'9807, kDataType = 0x0018'9808;
inline constexpr DicomTag kSeries = 0x0020'000E, kAcquisition = 0x0020'0012, kInstance = 0x0020'0013,
                          kPosition = 0x0020'0032, kOrientation = 0x0020'0037, kTemporal = 0x0020'0100,
                          kStack = 0x0020'9056, kInStackPosition = 0x0020'9057, kFrameContent = 0x0020'9111,
                          kPlanePosition = 0x0020'9113, kPlaneOrientation = 0x0020'9116,
                          kTemporalIndex = 0x0020'9128, kDimensionValues = 0x0020'9157,
                          kDimensionPointer = 0x0020'9165, kDimensions = 0x0020'9222,
                          kOrganisation = 0x0020'9311, kTriggerDelay = 0x0020'9153,
                          kFrameAcquisition = 0x0020'9156, kVolumePosition = 0x0020'9301,
                          kVolumeOrientation = 0x0020'9302, kScanGeometry = 0x0020'9307, kApex = 0x0020'9308,
                          kToTransducer = 0x0020'9309, kTemporalOffset = 0x0020'930D,
                          kVolumePlanePosition = 0x0020'930E, kVolumePlaneOrientation = 0x0020'930F,
                          kTemporalPosition = 0x0020'9310;
inline constexpr DicomTag kSamples = 0x0028'0002, kPhotometric = 0x0028'0004, kPlanar = 0x0028'0006,
                          kFrames = 0x0028'0008, kFrameIncrement = 0x0028'0009, kRows = 0x0028'0010,
                          kColumns = 0x0028'0011, kPixelSpacing = 0x0028'0030, kAspectRatio = 0x0028'0034,
                          kAllocated = 0x0028'0100, kStored = 0x0028'0101, kHighBit = 0x0028'0102,
                          kSigned = 0x0028'0103, kPadding = 0x0028'0120, kPaddingLimit = 0x0028'0121,
                          kBurnedIn = 0x0028'0301, kIntercept = 0x0028'1052, kSlope = 0x0028'1053,
                          kPalette = 0x0028'1101, kPaletteRed = 0x0028'1201, kSegmentedPalette = 0x0028'1221,
                          kPixelMeasures = 0x0028'9110, kPixelTransform = 0x0028'9145;
inline constexpr DicomTag kDetectors = 0x0054'0022, kFrameOffsets = 0x3004'000C;
inline constexpr DicomTag kSharedGroups = 0x5200'9229, kFrameGroups = 0x5200'9230;
inline constexpr DicomTag kFrameStarts = 0x7FE0'0001, kFloatPixels = 0x7FE0'0008, kDoublePixels = 0x7FE0'0009,
                          kPixels = 0x7FE0'0010;
inline constexpr DicomTag kItem = 0xFFFE'E000, kItemEnd = 0xFFFE'E00D, kSequenceEnd = 0xFFFE'E0DD;

// Of makers: the element's number within the block that the maker has reserved, and so never a tag of a file.
inline constexpr DicomTag kPhilipsSlices = 0x3001'0001, kPhilipsUnitsZ = 0x3001'0002,
                          kPhilipsDeltaZ = 0x3001'0003;                               // QLAB
inline constexpr DicomTag kPhilipsDims = 0x200D'0001, kPhilipsSpacing = 0x200D'0003,  // Affinity, iU22
    kPhilipsVoxels = 0x200D'000B, kPhilipsNative = 0x200D'00F8;
inline constexpr DicomTag kEigenSpacing = 0x1129'0016;
inline constexpr DicomTag kKretzFile = 0x7FE1'0001, kMovieGroup = 0x7FE1'0002;
}  // namespace tag

// dicomType: the type by which the standard has an element, such as "US"; empty: it is not taken.
//   output  "XS" where the file's pixels tell whether it has a sign
std::string_view dicomType(DicomTag tag);

// PrivateElement: what a maker's element is taken as, and its type; "UN": that it is there is all that is taken.
struct PrivateElement {
  DicomTag name = 0;
  std::string_view type;
};
// privateElement: that of a maker's block; `name` 0: it is not taken.
PrivateElement privateElement(std::string_view creator, DicomTag tag);
// reservesBlock: whether an element names the maker whose block a group's elements belong to, in a group that is taken.
bool reservesBlock(DicomTag tag);

}  // namespace sonoskin
