#include "core/io/stored_volume.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/header_text.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

static_assert(std::endian::native == std::endian::little,
              "big-endian files are turned round, others are not");

constexpr std::uint64_t kMaxVoxels = std::uint64_t(1) << 31;
constexpr std::uintmax_t kDeflateRatio = 1032;  // the most that deflate can gain (zlib.net/zlib_tech.html)
constexpr std::size_t kChunk = 1u << 20;

struct TypeFacts {
  std::string_view name;
  std::size_t bytes;
};
constexpr std::array<TypeFacts, 10> kTypes{{{"int8", 1},
                                            {"uint8", 1},
                                            {"int16", 2},
                                            {"uint16", 2},
                                            {"int32", 4},
                                            {"uint32", 4},
                                            {"int64", 8},
                                            {"uint64", 8},
                                            {"float32", 4},
                                            {"float64", 8}}};

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

[[noreturn]] void failTruncated(const fs::path& path) {
  throw Error(fmt::format("{} ends before all of its voxels; the copy is incomplete, get a fresh one.",
                          path.string()));
}

// Gram-Schmidt, for axes that are at right angles within what a header's decimals can say.
void orthonormalise(Geometry& g, const fs::path& path) {
  constexpr double kTolerance = 1e-3;
  const glm::dmat3 error = glm::transpose(g.direction) * g.direction - glm::dmat3(1);
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      require(std::abs(error[c][r]) < kTolerance,
              "The axes in {} are not at right angles; resample the volume to a straight grid first.",
              path.string());
  glm::dvec3 &x = g.direction[0], &y = g.direction[1], &z = g.direction[2];
  x = glm::normalize(x);
  y = glm::normalize(y - glm::dot(x, y) * x);
  z = glm::cross(x, y) * (glm::dot(glm::cross(x, y), z) < 0 ? -1.0 : 1.0);
}

void checkDims(const glm::ivec3& dims, const fs::path& path) {
  for (int a = 0; a < 3; ++a) {
    require(dims[a] != 1, "{} is a flat picture of {} x {} x {}; choose a volume, or the whole series.",
            path.string(), dims.x, dims.y, dims.z);
    require(dims[a] >= 2 && dims[a] <= 65535,
            "{} says that it has {} voxels along one axis; 2 to 65535 are possible.", path.string(), dims[a]);
  }
  const std::uint64_t voxels = std::uint64_t(dims.x) * std::uint64_t(dims.y) * std::uint64_t(dims.z);
  require(voxels <= kMaxVoxels,
          "{} says that it has {} x {} x {} voxels, more than fit into memory; crop it first.", path.string(),
          dims.x, dims.y, dims.z);
}

// All time steps, in unpacked bytes (text: numbers of at least one digit and one blank). At most 2^31 * 65535
// * 2^16.
void checkBytes(const StoredVolume& stored, const fs::path& path) {
  const std::uintmax_t size = fileSize(stored.dataFile);
  if (stored.fileOffset >= size) failTruncated(path);
  const std::uintmax_t left = size - stored.fileOffset;
  const std::uintmax_t numbers = std::uintmax_t(stored.geometry.voxels()) * std::uintmax_t(stored.components);
  std::uintmax_t all = 0, available = left;
  if (__builtin_mul_overflow(numbers, std::uintmax_t(stored.timeSteps), &all)) failTruncated(path);
  if (stored.encoding == Encoding::text) {
    available = left / 2 + 1;
  } else {
    if (__builtin_mul_overflow(all, numberTypeBytes(stored.type), &all)) failTruncated(path);
    if (stored.encoding == Encoding::deflate) {
      available = left * kDeflateRatio;
      if (stored.streamOffset > available) failTruncated(path);
      available -= stored.streamOffset;
    }
  }
  if (all > available) failTruncated(path);
}

// Unpacks a stream from `offset` on, skipping `skip` bytes of its content. Returns the bytes written to
// `out`.
class Inflater {
 public:
  Inflater(const fs::path& path, std::uintmax_t offset)
      : path_(path), file_(path, std::ios::binary), in_(kChunk) {
    require(bool(file_), "The file {} cannot be read; check its permissions.", path.string());
    file_.seekg(std::streamoff(offset));
    // 15 bits of window, and 32: find out whether the stream is of zlib or of gzip.
    if (inflateInit2(&stream_, 15 + 32) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  // read: fills `out` with up to `bytes` (at most kChunk); less only at the end of the stream.
  std::size_t read(std::uint8_t* out, std::size_t bytes) {
    stream_.next_out = out;
    stream_.avail_out = uInt(bytes);
    while (stream_.avail_out > 0 && refill()) {
      const int code = ::inflate(&stream_, Z_NO_FLUSH);
      if (code == Z_STREAM_END) {
        inflateReset(&stream_);  // gzip files may be several streams, one after another
        continue;
      }
      require(code == Z_OK || code == Z_BUF_ERROR, "The packed data in {} are damaged; get a fresh copy.",
              path_.string());
    }
    return bytes - stream_.avail_out;
  }

 private:
  bool refill() {
    if (stream_.avail_in > 0) return true;
    file_.read(reinterpret_cast<char*>(in_.data()), std::streamsize(in_.size()));
    stream_.next_in = in_.data();
    stream_.avail_in = uInt(file_.gcount());
    return stream_.avail_in > 0;
  }

  fs::path path_;
  std::ifstream file_;
  std::vector<std::uint8_t> in_;
  z_stream stream_{};
};

void readDeflate(const StoredVolume& stored, std::vector<std::uint8_t>& bytes, const Progress& progress) {
  Inflater inflater(stored.dataFile, stored.fileOffset);
  std::vector<std::uint8_t> skipped(kChunk);
  for (std::uintmax_t left = stored.streamOffset; left > 0;) {
    const std::size_t step = std::size_t(std::min<std::uintmax_t>(left, kChunk));
    if (inflater.read(skipped.data(), step) < step) failTruncated(stored.dataFile);
    left -= step;
    progress.throwIfCancelled();
  }
  for (std::size_t done = 0; done < bytes.size();) {
    const std::size_t step = std::min(bytes.size() - done, kChunk);
    if (inflater.read(bytes.data() + done, step) < step) failTruncated(stored.dataFile);
    done += step;
    progress.update(double(done) / double(bytes.size()));
  }
}

void readRaw(const StoredVolume& stored, std::vector<std::uint8_t>& bytes, const Progress& progress) {
  std::ifstream file(stored.dataFile, std::ios::binary);
  file.seekg(std::streamoff(stored.fileOffset));
  for (std::size_t done = 0; done < bytes.size();) {
    const std::size_t step = std::min(bytes.size() - done, 16 * kChunk);
    file.read(reinterpret_cast<char*>(bytes.data() + done), std::streamsize(step));
    if (!file) failTruncated(stored.dataFile);
    done += step;
    progress.update(double(done) / double(bytes.size()));
  }
}

// Text becomes float64: StoredVolume::type is then what the reader of the numbers must take.
void readText(const StoredVolume& stored, std::vector<std::uint8_t>& bytes, const Progress& progress) {
  std::ifstream file(stored.dataFile, std::ios::binary);
  file.seekg(std::streamoff(stored.fileOffset));
  const std::size_t count = bytes.size() / sizeof(double);
  std::string word;
  for (std::size_t n = 0; n < count; ++n) {
    if (!(file >> word)) failTruncated(stored.dataFile);
    const auto value = parseNumber<double>(word);
    require(value.has_value(), "The voxels in {} are not all numbers; get a fresh copy.",
            stored.dataFile.string());
    std::memcpy(bytes.data() + n * sizeof(double), &*value, sizeof(double));
    if (n % kChunk == 0) progress.update(double(n) / double(count));
  }
}

void swapBytes(std::vector<std::uint8_t>& bytes, std::size_t size) {
  for (std::size_t at = 0; at + size <= bytes.size(); at += size)
    std::reverse(bytes.data() + at, bytes.data() + at + size);
}

}  // namespace

std::string_view numberTypeName(NumberType type) { return kTypes[std::size_t(type)].name; }
std::size_t numberTypeBytes(NumberType type) { return kTypes[std::size_t(type)].bytes; }

void checkGeometry(StoredVolume& stored, const fs::path& path) {
  Geometry& g = stored.geometry;
  checkDims(g.dims, path);
  require(finite(g.spacing) && g.spacing.x > 0 && g.spacing.y > 0 && g.spacing.z > 0,
          "The spacing in {} is {} x {} x {}; it must be positive, correct the header.", path.string(),
          g.spacing.x, g.spacing.y, g.spacing.z);
  require(finite(g.origin), "The origin in {} is not a finite position; correct the header.", path.string());
  for (int a = 0; a < 3; ++a)
    require(finite(g.direction[a]), "The direction of the axes in {} is not finite; correct the header.",
            path.string());
  orthonormalise(g, path);
  require(stored.timeSteps >= 1 && stored.components >= 1, "{} says that it has no voxels; get a fresh copy.",
          path.string());
  require(stored.components == 1 || stored.components == 3 || stored.components == 4 || stored.timeIsFastest,
          "{} has {} numbers per voxel; a volume has one, or three or four of colour.", path.string(),
          stored.components);
}

void checkStored(StoredVolume& stored, const fs::path& path) {
  checkGeometry(stored, path);
  checkBytes(stored, path);
}

std::vector<std::uint8_t> readNumbers(const StoredVolume& stored, const Progress& progress) {
  progress.update(0);
  const std::size_t size = stored.encoding == Encoding::text ? sizeof(double) : numberTypeBytes(stored.type);
  std::vector<std::uint8_t> bytes(stored.geometry.voxels() * std::size_t(stored.components) * size);
  switch (stored.encoding) {
    case Encoding::raw:
      readRaw(stored, bytes, progress);
      break;
    case Encoding::deflate:
      readDeflate(stored, bytes, progress);
      break;
    case Encoding::text:
      readText(stored, bytes, progress);
      break;
  }
  if (stored.bigEndian && stored.encoding != Encoding::text && size > 1) swapBytes(bytes, size);
  return bytes;
}

std::vector<std::uint8_t> inflateStart(const fs::path& path, std::size_t bytes) {
  std::vector<std::uint8_t> start(bytes);
  start.resize(Inflater(path, 0).read(start.data(), bytes));
  return start;
}

}  // namespace sonoskin
