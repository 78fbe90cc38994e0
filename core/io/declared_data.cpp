#include "core/io/declared_data.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <new>

#include "core/base/error.h"
#include "core/io/file_bytes.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t kDeflateRatio = 1032;  // the most that deflate can gain (zlib.net/zlib_tech.html)
constexpr std::uintmax_t kMaxNumbers = std::uintmax_t(1) << 33;
constexpr std::size_t kChunk = 1u << 18;
constexpr std::uintmax_t kTrusted = 64u << 20;  // bytes for which memory is taken before they have come

[[noreturn]] void failTruncated(const fs::path& path) {
  throw Error(fmt::format("{} ends before all of its voxels; the copy is incomplete, get a fresh one.",
                          path.string()));
}

// Unpacks a stream: ITK reads MetaImages that end early as if they were whole.
//   kept  gets what is unpacked; null: it is not kept
void checkStream(const DeclaredData& data, std::uintmax_t bytes, std::vector<std::uint8_t>* kept) {
  z_stream stream{};
  // 15 bits of window, and 32: find out whether the stream is of zlib or of gzip.
  if (inflateInit2(&stream, 15 + 32) != Z_OK) throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_stream*)> owner(&stream, inflateEnd);
  std::ifstream file(data.file, std::ios::binary);
  file.seekg(std::streamoff(data.offset));
  std::vector<std::uint8_t> in(kChunk), out(kChunk);
  std::uintmax_t left = data.packedBytes, unpacked = 0;
  bool ended = false;
  while (!ended || unpacked < bytes) {
    if (stream.avail_in == 0) {
      file.read(reinterpret_cast<char*>(in.data()), std::streamsize(std::min<std::uintmax_t>(left, kChunk)));
      stream.next_in = in.data();
      stream.avail_in = uInt(file.gcount());
      left -= stream.avail_in;
      if (stream.avail_in == 0) failTruncated(data.file);
    }
    if (ended) inflateReset(&stream);  // gzip files may be several streams, one after another
    stream.next_out = out.data();
    stream.avail_out = uInt(out.size());
    const int code = inflate(&stream, Z_NO_FLUSH);
    require(code == Z_OK || code == Z_BUF_ERROR || code == Z_STREAM_END,
            "The packed data in {} are damaged; get a fresh copy.", data.file.string());
    const std::size_t came = out.size() - stream.avail_out;
    if (kept) kept->insert(kept->end(), out.begin(), out.begin() + std::ptrdiff_t(came));
    unpacked += came;
    require(unpacked <= bytes + kChunk, "{} holds more than its header declares; get a fresh copy.",
            data.file.string());
    ended = code == Z_STREAM_END;
  }
}

// ITK takes whatever stands in the place of a number for the one before.
void checkText(const DeclaredData& data, std::uintmax_t numbers) {
  std::ifstream file(data.file, std::ios::binary);
  file.seekg(std::streamoff(data.offset));
  double value = 0;
  for (std::uintmax_t n = 0; n < numbers; ++n) {
    if (file >> value) continue;
    if (file.eof()) failTruncated(data.file);
    throw Error(fmt::format("The voxels in {} are not all numbers; get a fresh copy.", data.file.string()));
  }
}

}  // namespace

std::vector<std::uint8_t> checkData(const DeclaredData& data, const fs::path& path) {
  std::vector<std::uint8_t> kept;
  std::uintmax_t numbers = std::uintmax_t(data.components);
  for (const std::int64_t size : data.sizes) {
    require(size >= 1 && size <= 65535,
            "{} says that it has {} voxels along one axis; 2 to 65535 are possible.", path.string(), size);
    numbers *= std::uintmax_t(size);
    require(numbers <= kMaxNumbers,
            "{} says that it has at least {} voxels, more than fit into memory; crop it first.",
            path.string(), numbers);
  }
  const std::uintmax_t bytes = numbers * data.bytesPerNumber;
  require(data.skipped <= kMaxNumbers, "{} ends before its voxels begin; get a fresh copy.", path.string());
  const std::uintmax_t size = fileSize(data.file);
  if (data.offset >= size || data.packedBytes > size - data.offset) failTruncated(data.file);
  const std::uintmax_t left = size - data.offset;
  switch (data.encoding) {
    case Encoding::raw:
      if (bytes > left) failTruncated(data.file);
      break;
    case Encoding::packed: {
      DeclaredData stream = data;
      if (stream.packedBytes == 0) stream.packedBytes = left;
      if ((bytes + data.skipped) / kDeflateRatio > stream.packedBytes) failTruncated(data.file);
      const bool keeps = data.bytesPerNumber == 1 && data.skipped == 0;
      if (keeps) kept.reserve(std::size_t(std::min(bytes, kTrusted)) + kChunk);
      checkStream(stream, bytes + data.skipped, keeps ? &kept : nullptr);
      kept.resize(keeps ? std::size_t(bytes) : 0);
      break;
    }
    case Encoding::text:
      if (numbers > left / 2 + 1) failTruncated(data.file);
      checkText(data, numbers);
      break;
  }
  return kept;
}

std::uint64_t numbersIn(const DeclaredData& data) {
  std::uint64_t numbers = std::uint64_t(data.components);
  for (const std::int64_t size : data.sizes) numbers *= std::uint64_t(size);
  return numbers;
}

std::vector<std::uint8_t> inflatedStart(const fs::path& path, std::size_t bytes) {
  fileSize(path);
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  require(file != nullptr, "The file {} cannot be read; check its permissions.", path.string());
  std::vector<std::uint8_t> start(bytes);
  start.resize(std::size_t(std::max(0, gzread(file.get(), start.data(), unsigned(bytes)))));
  return start;
}

}  // namespace sonoskin
