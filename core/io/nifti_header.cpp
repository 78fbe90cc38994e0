// NIfTI-1 headers in one file with the voxels (nifti.nimh.nih.gov/pub/dist/src/niftilib/nifti1.h).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/stored_volume.h"

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
  double real(std::size_t offset) const { return double(get<float>(offset)); }
  std::int64_t dim(int n) const { return get<std::int16_t>(40 + 2 * std::size_t(n)); }
  double pixdim(int n) const { return real(76 + 4 * std::size_t(n)); }
  bool swapped() const { return swapped_; }

 private:
  std::vector<std::uint8_t> bytes_;
  bool swapped_ = false;
};

std::optional<std::pair<NumberType, int>> typeOf(int code) {
  switch (code) {
    case 2:
      return {{NumberType::uint8, 1}};
    case 4:
      return {{NumberType::int16, 1}};
    case 8:
      return {{NumberType::int32, 1}};
    case 16:
      return {{NumberType::float32, 1}};
    case 64:
      return {{NumberType::float64, 1}};
    case 128:
      return {{NumberType::uint8, 3}};
    case 256:
      return {{NumberType::int8, 1}};
    case 512:
      return {{NumberType::uint16, 1}};
    case 768:
      return {{NumberType::uint32, 1}};
    case 1024:
      return {{NumberType::int64, 1}};
    case 1280:
      return {{NumberType::uint64, 1}};
    case 2304:
      return {{NumberType::uint8, 4}};
    default:
      return {};
  }
}

void readSizes(const Header& header, const fs::path& path, StoredVolume& stored) {
  const std::int64_t dimensions = header.dim(0);
  require(dimensions >= 3 && dimensions <= 7, "{} has {} dimensions; a volume has 3, or 4 with time.",
          path.string(), dimensions);
  for (int n = 1; n <= dimensions; ++n)
    require(header.dim(n) >= 1, "{} says that it has {} voxels along one axis; 2 to 65535 are possible.",
            path.string(), header.dim(n));
  for (int n = 5; n <= dimensions; ++n)
    require(header.dim(n) == 1, "{} has more than one number per voxel, which is not known here.",
            path.string());
  for (int a = 0; a < 3; ++a) stored.geometry.dims[a] = int(header.dim(a + 1));
  if (dimensions >= 4) stored.timeSteps = int(header.dim(4));
  const int code = header.get<std::int16_t>(70);
  const auto type = typeOf(code);
  require(type.has_value(), "{} has numbers of the type {}, which is not known here.", path.string(), code);
  std::tie(stored.type, stored.components) = *type;
}

// The rotation of the unit quaternion (a, b, c, d) with a >= 0; method 2 of the standard.
glm::dmat3 rotation(double b, double c, double d) {
  const double a = std::sqrt(std::max(0.0, 1 - b * b - c * c - d * d));
  return glm::transpose(glm::dmat3(                                             // written row by row
      a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c),  //
      2 * (b * c + a * d), a * a + c * c - b * b - d * d, 2 * (c * d - a * b),  //
      2 * (b * d - a * c), 2 * (c * d + a * b), a * a + d * d - b * b - c * c));
}

// From RAS, the frame of NIfTI, to LPS.
void toLps(Geometry& g) {
  const glm::dvec3 flip(-1, -1, 1);
  g.origin *= flip;
  for (int a = 0; a < 3; ++a) g.direction[a] *= flip;
}

// qform where the file has one: it cannot shear and is what a scanner writes; else sform; else the axes as
// they are.
void readPlace(const Header& header, StoredVolume& stored) {
  Geometry& g = stored.geometry;
  stored.spacingKnown = header.pixdim(1) != 0 && header.pixdim(2) != 0 && header.pixdim(3) != 0;
  for (int a = 0; a < 3 && stored.spacingKnown; ++a) g.spacing[a] = header.pixdim(a + 1);
  if (header.get<std::int16_t>(252) > 0) {
    g.direction = rotation(header.real(256), header.real(260), header.real(264));
    if (header.pixdim(0) < 0) g.direction[2] = -g.direction[2];
    g.origin = {header.real(268), header.real(272), header.real(276)};
  } else if (header.get<std::int16_t>(254) > 0) {
    for (int a = 0; a < 3; ++a) {
      const std::size_t row = 280 + 16 * std::size_t(a);
      g.origin[a] = header.real(row + 12);
      for (int axis = 0; axis < 3; ++axis) g.direction[axis][a] = header.real(row + 4 * std::size_t(axis));
    }
    for (int axis = 0; axis < 3; ++axis) {
      g.spacing[axis] = glm::length(g.direction[axis]);
      g.direction[axis] /= g.spacing[axis];
    }
    stored.spacingKnown = true;
  }
  toLps(g);
  const int unit = header.get<std::uint8_t>(123) & 7;  // 1 metres, 2 millimetres, 3 micrometres
  const double mm = unit == 1 ? 1000 : unit == 3 ? 0.001 : 1;
  g.spacing *= mm;
  g.origin *= mm;
}

}  // namespace

StoredVolume readNiftiHeader(const fs::path& path) {
  const bool packed = lowerExtension(path) == ".nii.gz";
  std::vector<std::uint8_t> bytes = packed ? inflateStart(path, kHeaderBytes) : readBytes(path, kHeaderBytes);
  require(bytes.size() == kHeaderBytes, "{} ends within its header; get a fresh copy.", path.string());
  const bool single = !std::memcmp(bytes.data() + 344, "n+1", 4);
  const Header header(std::move(bytes));
  require(single && header.get<std::int32_t>(0) == std::int32_t(kHeaderBytes),
          "{} is not a NIfTI-1 file with header and voxels in one; convert it to .nii.gz.", path.string());
  StoredVolume stored;
  stored.format = "NIfTI";
  stored.dataFile = path;
  stored.bigEndian = header.swapped();
  readSizes(header, path, stored);
  readPlace(header, stored);
  const double offset = header.real(108);
  require(offset >= 348 && offset < 1e9, "{} does not say where its voxels begin; get a fresh copy.",
          path.string());
  stored.encoding = packed ? Encoding::deflate : Encoding::raw;
  (packed ? stored.streamOffset : stored.fileOffset) = std::uintmax_t(offset);
  const double slope = header.real(112), intercept = header.real(116);
  if (std::isfinite(slope) && std::isfinite(intercept) && slope != 0 && stored.components == 1) {
    stored.slope = slope;
    stored.intercept = intercept;
  }
  return stored;
}

}  // namespace sonoskin
