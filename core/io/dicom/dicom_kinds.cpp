// Files of DICOM that hold no volume, or one that only its maker's programs read.
#include <array>
#include <string_view>

#include "core/io/dicom/dicom_makers.h"

namespace sonoskin {
namespace {

struct Kind {
  std::string_view classUid;  // or how those of its kind begin
  std::string_view holds, instead;
};
constexpr std::string_view kStorage = "1.2.840.10008.5.1.4.1.1.";
// After kStorage [DICOM PS3.4, B.5].
constexpr auto kKinds = std::to_array<Kind>({
    {"104.1", "a PDF document", "choose the series of pictures"},
    {"104.2", "a document", "choose the series of pictures"},
    {"104.3", "a mesh (STL)", "save it from there as .stl"},
    {"104.4", "a mesh (OBJ)", "save it from there as .obj"},
    {"104.5", "a mesh's materials (MTL)", "save the mesh from there as .obj"},
    {"88.", "a report", "choose the series of pictures"},
    {"11.", "how pictures are shown", "choose the series of pictures"},
    {"9.", "a wave form", "choose the series of pictures"},
    {"66", "raw data of its maker", "export the volume from the machine as DICOM, or as NRRD"},
    {"66.5", "a mesh of surfaces (segmentation)", "save it from there as .stl"},
    {"481.3", "contours", "choose the series of pictures"},
    {"481.5", "a plan of treatment", "choose the series of pictures"},
});

bool isOf(std::string_view uid, const Kind& kind) {
  if (!uid.starts_with(kStorage)) return false;
  uid.remove_prefix(kStorage.size());
  return kind.classUid.ends_with('.') ? uid.starts_with(kind.classUid) : uid == kind.classUid;
}

}  // namespace

void refuseOtherKinds(const DicomItem& root, const std::filesystem::path& path) {
  const std::string uid = root.text(tag::kSopClass);
  for (const Kind& kind : kKinds)
    require(!isOf(uid, kind), "{} holds {}, not a volume; {}.", path.string(), kind.holds, kind.instead);
  require(
      root.text(tag::kImageType).find("MOSAIC") == std::string::npos,
      "{} holds many slices in one picture (a mosaic), which are not taken apart here; convert it to NIfTI "
      "with dcm2niix.",
      path.string());
  if (root.find(tag::kKretzFile)) return;
  const bool isPlaced = root.find(tag::kPosition) || root.find(tag::kFrameGroups);
  require(
      isPlaced || !root.find(tag::kMovieGroup),
      "{} holds a volume in GE's own form (MovieGroup), which only GE's programs read; export it there as "
      "Cartesian DICOM, or open it in 3D Slicer with GE's Image3dAPI and save it as NRRD.",
      path.string());
  require(isPlaced || !root.find(tag::kPhilipsNative),
          "{} holds a volume in Philips' own form, which only Philips' programs read; export it from QLAB as "
          "Cartesian DICOM.",
          path.string());
}

}  // namespace sonoskin
