// NIfTI-1 headers in one file with the voxels (nifti.nimh.nih.gov/pub/dist/src/niftilib/nifti1.h).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "core/base/error.h"
#include "core/io/declared_data.h"
#include "core/io/file_bytes.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kHeaderBytes = 348;

// The 348 bytes, read field by field in the file's byte order.
class Header {
 public:
  explicit Header(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {
    swapped_ = get<std::int32_t>(0) != std::int32_t(kHeaderBytes);
  }
  template <class T>
  T get(std::size_t offset) const {
    std::array<std::uint8_t, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes_.data() + offset, sizeof(T));
    if (swapped_) std::reverse(raw.begin(), raw.end());
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return value;
  }
  std::int64_t dim(int n) const { return get<std::int16_t>(40 + 2 * std::size_t(n)); }
  float pixdim(int n) const { return get<float>(76 + 4 * std::size_t(n)); }

 private:
  std::vector<std::uint8_t> bytes_;
  bool swapped_ = false;
};

// Bytes per number and numbers per voxel.
std::pair<std::size_t, int> typeOf(int code) {
  switch (code) {
    case 2:    // uint8
    case 256:  // int8
      return {1, 1};
    case 4:    // int16
    case 512:  // uint16
      return {2, 1};
    case 8:    // int32
    case 768:  // uint32
    case 16:   // float
      return {4, 1};
    case 64:    // double
    case 1024:  // int64
    case 1280:  // uint64
      return {8, 1};
    case 128:  // red, green, blue
      return {1, 3};
    case 2304:  // and opacity
      return {1, 4};
    default:
      return {0, 0};
  }
}

std::vector<std::int64_t> sizesOf(const Header& header, const fs::path& path) {
  const std::int64_t dimensions = header.dim(0);
  require(dimensions >= 3 && dimensions <= 7, "{} has {} dimensions; a volume has 3, or 4 with time.",
          path.string(), dimensions);
  for (int n = 5; n <= dimensions; ++n)
    require(header.dim(n) == 1,
            "{} has more than one number per voxel, which is not known here; save one of them.",
            path.string());
  std::vector<std::int64_t> sizes;
  for (int n = 1; n <= std::min<std::int64_t>(dimensions, 4); ++n) sizes.push_back(header.dim(n));
  return sizes;
}

// The fields that place the voxels in the world: pixdim, the quaternion, the matrix.
void checkPlace(const Header& header, const fs::path& path) {
  const auto sound = [](float v) { return v == 0 || std::isnormal(v); };
  for (int n = 0; n < 4; ++n)
    require(sound(header.pixdim(n)), "The spacing in {} makes no sense; correct the header.", path.string());
  for (std::size_t offset = 256; offset < 328; offset += sizeof(float))
    require(sound(header.get<float>(offset)),
            "The origin or the direction of the axes in {} makes no sense; correct the header.",
            path.string());
}

}  // namespace

DeclaredData niftiData(const fs::path& path) {
  const bool packed = lowerExtension(path) == ".nii.gz";
  std::vector<std::uint8_t> bytes =
      packed ? inflatedStart(path, kHeaderBytes) : readBytes(path, kHeaderBytes);
  require(bytes.size() == kHeaderBytes, "{} ends within its header; get a fresh copy.", path.string());
  const bool single = !std::memcmp(bytes.data() + 344, "n+1", 4);
  const Header header(std::move(bytes));
  require(single && header.get<std::int32_t>(0) == std::int32_t(kHeaderBytes),
          "{} is not a NIfTI-1 file with header and voxels in one; convert it to .nii.gz.", path.string());
  DeclaredData data;
  data.sizes = sizesOf(header, path);
  const int code = header.get<std::int16_t>(70);
  const auto [numberBytes, components] = typeOf(code);
  require(numberBytes > 0,
          "{} has numbers of the type {}, which is not known here; save it with whole numbers or as float.",
          path.string(), code);
  data.bytesPerNumber = numberBytes;
  data.components = components;
  checkPlace(header, path);
  const float offset = header.get<float>(108);
  require(offset >= 348 && offset < 1e9f, "{} does not say where its voxels begin; get a fresh copy.",
          path.string());
  data.file = path;
  data.encoding = packed ? Encoding::packed : Encoding::raw;
  (packed ? data.skipped : data.offset) = std::uintmax_t(offset);
  data.spacingKnown = header.pixdim(1) != 0 && header.pixdim(2) != 0 && header.pixdim(3) != 0;
  return data;
}

}  // namespace sonoskin
