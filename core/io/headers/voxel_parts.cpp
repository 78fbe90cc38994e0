#include "core/io/headers/voxel_parts.h"

#include <algorithm>
#include <fstream>

#include "core/base/error.h"
#include "core/io/headers/data_files.h"
#include "core/io/headers/text_numbers.h"
#include "core/io/headers/unpacking.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uintmax_t kMostSkipped = std::uintmax_t(1) << 33;
constexpr std::uintmax_t kTrusted = 64u << 20;  // bytes for which memory is taken before they have come
constexpr std::uintmax_t kDeflateRatio = 1032;  // the most that deflate can gain (zlib.net/zlib_tech.html)
constexpr std::uintmax_t kBzip2Ratio =
    20'000;  // more than any picture's; bzip2 itself knows no bound near that
constexpr std::uintmax_t kLongestLines = 1u << 24;  // bytes that "line skip" may pass over

[[noreturn]] void failTruncated(const fs::path& path) {
  throw Error(fmt::format("{} ends before all of its voxels; the copy is incomplete, get a fresh one.",
                          path.string()));
}

// Takes what of some bytes, which begin at `at`, lies in the range.
class Window {
 public:
  Window(const Stretch& range, Bytes& out) : range_(range), out_(out) {}
  void take(std::uintmax_t at, std::span<const std::uint8_t> bytes) {
    const Stretch part = within(at, bytes.size());
    if (part.first < part.last)
      out_.insert(out_.end(), bytes.begin() + std::ptrdiff_t(part.first),
                  bytes.begin() + std::ptrdiff_t(part.last));
  }
  // within: which of `count` bytes that begin at `at` are wanted, counted from there.
  Stretch within(std::uintmax_t at, std::uintmax_t count) const {
    const std::uintmax_t first = std::max(at, range_.first), last = std::min(at + count, range_.last);
    return first < last ? Stretch{first - at, last - at} : Stretch{};
  }
  Bytes& out() { return out_; }

 private:
  Stretch range_;
  Bytes& out_;
};

void skipLines(DataPart& part, std::int64_t lines) {
  if (lines == 0) return;
  std::ifstream file(part.file, std::ios::binary);
  file.seekg(std::streamoff(part.offset));
  for (std::uintmax_t n = 0; lines > 0 && n < kLongestLines; ++n) {
    const int c = file.get();
    if (c == std::char_traits<char>::eof()) failTruncated(part.header);
    ++part.offset;
    lines -= c == '\n';
  }
  require(lines == 0, "The lines to be skipped in {} are longer than lines are; save it again without.",
          part.header.string());
}

// Refuses a part that cannot hold its bytes, before memory is taken for them.
void checkPart(const DeclaredData& data, const DataPart& part, std::uintmax_t bytes) {
  const std::uintmax_t size = dataFileSize(part.file, part.header);
  require(data.bytesSkipped <= kMostSkipped, "{} ends before its voxels begin; get a fresh copy.",
          part.header.string());
  if (part.offset >= size || part.bytes > size - part.offset) failTruncated(part.header);
  const std::uintmax_t left = part.bytes > 0 ? part.bytes : size - part.offset,
                       all = bytes + data.bytesSkipped;
  const std::uintmax_t numbers = bytes / numberTypeBytes(data.type);
  bool fits = true;
  if (data.encoding == Encoding::raw) fits = data.lastBytes ? bytes <= left : all <= left;
  if (data.encoding == Encoding::packed) fits = all / kDeflateRatio <= left;
  if (data.encoding == Encoding::bzip2) fits = all <= kTrusted || all / kBzip2Ratio <= left;
  if (data.encoding == Encoding::text) fits = numbers <= left / 2 + 1;
  if (data.encoding == Encoding::hex) fits = bytes <= left / 2;
  if (!fits) failTruncated(part.header);
}

void readRaw(const DataPart& part, const Stretch& within, Bytes& out, const Progress& progress) {
  constexpr std::size_t kPiece = 16u << 20;
  std::ifstream file(part.file, std::ios::binary);
  file.seekg(std::streamoff(part.offset + within.first));
  const std::size_t begin = out.size(), count = std::size_t(within.last - within.first);
  out.resize(begin + count);
  for (std::size_t done = 0; done < count; done += kPiece) {
    progress.update(double(done) / double(count));
    const std::size_t piece = std::min(kPiece, count - done);
    file.read(reinterpret_cast<char*>(out.data() + begin + done), std::streamsize(piece));
    if (std::size_t(file.gcount()) != piece) failTruncated(part.header);
  }
}

void readText(const DeclaredData& data, const DataPart& part, std::uintmax_t bytes, const Sink& sink) {
  std::ifstream file(part.file, std::ios::binary);
  file.seekg(std::streamoff(part.offset + data.bytesSkipped));
  if (data.encoding == Encoding::hex)
    readHexBytes(file, bytes, part.header, sink);
  else
    readTextNumbers(file, data.type, bytes / numberTypeBytes(data.type), part.header, sink);
}

// Share: what one part holds of all bytes.
struct Share {
  std::uintmax_t at = 0, bytes = 0;
};

void readPart(const DeclaredData& data, DataPart part, const Share& share, Window& window,
              const Progress& progress) {
  const std::uintmax_t at = share.at, bytes = share.bytes;
  const std::uintmax_t size = dataFileSize(part.file, part.header);
  skipLines(part, data.linesSkipped);
  checkPart(data, part, bytes);
  if (data.encoding == Encoding::raw) {
    if (data.lastBytes) part.offset = size - bytes;
    if (!data.lastBytes) part.offset += data.bytesSkipped;
    if (const Stretch within = window.within(at, bytes); within.first < within.last)
      readRaw(part, within, window.out(), progress);
    return;
  }
  const bool unpacks = data.encoding == Encoding::packed || data.encoding == Encoding::bzip2;
  std::uintmax_t skip = unpacks ? data.bytesSkipped : 0, done = 0;
  const Sink sink = [&](std::span<const std::uint8_t> came) {
    const std::size_t skipped = std::size_t(std::min<std::uintmax_t>(skip, came.size()));
    skip -= skipped;
    came = came.subspan(skipped);
    came = came.first(std::size_t(std::min<std::uintmax_t>(came.size(), bytes - done)));
    window.take(at + done, came);
    done += came.size();
    progress.update(double(done) / double(bytes));
  };
  if (unpacks)
    unpack(part, data.encoding, bytes + data.bytesSkipped, sink);
  else
    readText(data, part, bytes, sink);
}

}  // namespace

Bytes readStretch(const DeclaredData& data, const Stretch& range, std::uintmax_t all, const fs::path& path,
                  const Progress& progress) {
  Bytes bytes;
  bytes.reserve(std::size_t(std::min(range.last - range.first, kTrusted)));
  Window window(range, bytes);
  const std::uintmax_t inEach = all / data.parts.size();
  for (std::size_t p = 0; p < data.parts.size(); ++p) {
    const double from = double(p) / double(data.parts.size()), to = double(p + 1) / double(data.parts.size());
    DataPart part = data.parts[p];
    part.header = path;
    readPart(data, part, {p * inEach, inEach}, window, progress.part(from, to));
  }
  return bytes;
}

}  // namespace sonoskin
