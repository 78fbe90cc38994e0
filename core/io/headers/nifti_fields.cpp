#include "core/io/headers/nifti_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/file_bytes.h"
#include "core/io/headers/unpacking.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kBytes1 = 348, kBytes2 = 540;

// The bytes, read field by field in the file's byte order.
class Header {
 public:
  Header(std::vector<std::uint8_t> bytes, bool swapped) : bytes_(std::move(bytes)), swapped_(swapped) {}
  template <class T>
  T get(std::size_t offset) const {
    std::array<std::uint8_t, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes_.data() + offset, sizeof(T));
    if (swapped_) std::reverse(raw.begin(), raw.end());
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return value;
  }

 private:
  std::vector<std::uint8_t> bytes_;
  bool swapped_;
};

// The fields that both versions have, in types of their own.
struct Places {
  std::size_t dim, datatype, pixdim, slope, units, qcode, scode, quaternion, srow;
};
constexpr Places kVersion1{40, 70, 76, 112, 123, 252, 254, 256, 280},
    kVersion2{16, 12, 104, 176, 500, 344, 348, 352, 400};

template <class Size, class Real, class Code>
NiftiFields fieldsOf(const Header& h, const Places& at) {
  NiftiFields f;
  const auto real = [&](std::size_t begin, std::size_t n) {
    return double(h.get<Real>(begin + n * sizeof(Real)));
  };
  for (std::size_t n = 0; n < 8; ++n) {
    f.dim[n] = h.get<Size>(at.dim + n * sizeof(Size));
    f.pixdim[n] = real(at.pixdim, n);
  }
  f.datatype = h.get<std::int16_t>(at.datatype);
  f.slope = real(at.slope, 0), f.intercept = real(at.slope, 1);
  f.qformCode = h.get<Code>(at.qcode), f.sformCode = h.get<Code>(at.scode);
  for (std::size_t n = 0; n < 3; ++n) {
    f.quaternion[n] = real(at.quaternion, n);
    f.qoffset[n] = real(at.quaternion, n + 3);
    for (std::size_t c = 0; c < 4; ++c) f.srow[n][c] = real(at.srow, 4 * n + c);
  }
  return f;
}

// Where the voxels begin, of an offset that may say nothing: behind the header, and in the same file behind
// the four bytes that tell of extensions.  [nifti1.h, "VOX_OFFSET"]
std::int64_t beginOf(std::int64_t offset, std::size_t header, const NiftiFields& f, const fs::path& path) {
  const auto least = std::int64_t(header);
  if (offset == 0 && !f.inTwoFiles) {
    log(LogLevel::warning, fmt::format("The header does not say where its voxels begin; they are taken from "
                                       "where NIfTI has them, at byte {}.",
                                       least + 4));
    return least + 4;
  }
  require(offset >= (f.inTwoFiles ? 0 : least) && offset < 1'000'000'000,
          "{} does not say where its voxels begin; get a fresh copy.", path.string());
  return offset;
}

NiftiFields version1(const std::vector<std::uint8_t>& bytes, bool swapped, const fs::path& path) {
  const std::string_view magic(reinterpret_cast<const char*>(bytes.data()) + 344, 3);
  require(magic == "n+1" || magic == "ni1",
          "{} is an ANALYZE 7.5 header, which does not tell left from right; convert it to .nii.gz.",
          path.string());
  const Header h(bytes, swapped);
  NiftiFields f = fieldsOf<std::int16_t, float, std::int16_t>(h, kVersion1);
  const float offset = h.get<float>(108);
  f.inTwoFiles = magic == "ni1";
  const bool isWhole = std::abs(offset) < 1e9f && offset == std::floor(offset);
  f.offset = beginOf(isWhole ? std::int64_t(offset) : -1, kBytes1, f, path);
  f.units = h.get<std::uint8_t>(kVersion1.units);
  return f;
}

NiftiFields version2(const std::vector<std::uint8_t>& bytes, bool swapped, const fs::path& path) {
  const std::string_view magic(reinterpret_cast<const char*>(bytes.data()) + 4, 3);
  require(magic == "n+2" || magic == "ni2", "{} is not a NIfTI file; convert it to .nii.gz.", path.string());
  const Header h(bytes, swapped);
  NiftiFields f = fieldsOf<std::int64_t, double, std::int32_t>(h, kVersion2);
  f.inTwoFiles = magic == "ni2";
  f.offset = beginOf(h.get<std::int64_t>(168), kBytes2, f, path);
  f.units = h.get<std::int32_t>(kVersion2.units);
  return f;
}

}  // namespace

NiftiFields niftiFields(const fs::path& path) {
  std::vector<std::uint8_t> bytes = unpackedStart(path, kBytes2);
  const auto sizeIs = [&](std::int32_t size, bool swapped) {
    return bytes.size() >= std::size_t(size) && Header(bytes, swapped).get<std::int32_t>(0) == size;
  };
  require(bytes.size() >= kBytes1, "{} ends within its header; get a fresh copy.", path.string());
  for (const bool swapped : {false, true}) {
    NiftiFields f;
    if (sizeIs(std::int32_t(kBytes1), swapped))
      f = version1(bytes, swapped, path);
    else if (sizeIs(std::int32_t(kBytes2), swapped))
      f = version2(bytes, swapped, path);
    else
      continue;
    f.swapped = swapped;
    return f;
  }
  throw Error(
      fmt::format("{} is not a NIfTI file; get a fresh copy, or convert it to .nii.gz.", path.string()));
}

}  // namespace sonoskin
