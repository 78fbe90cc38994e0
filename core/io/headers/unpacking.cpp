#include "core/io/headers/unpacking.h"

#include <bzlib.h>
#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <new>

#include "core/base/error.h"
#include "core/io/file_bytes.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kChunk = 1u << 18;

[[noreturn]] void failDamaged(const fs::path& path) {
  throw Error(fmt::format("The packed data in {} are damaged; get a fresh copy.", path.string()));
}

// Step: what one call of a library gave.
struct Step {
  std::size_t taken = 0, given = 0;
  bool ended = false;  // a stream; another may follow
};

// Of zlib and of gzip.
class Inflater {
 public:
  Inflater() {
    // 15 bits of window, and 32: find out whether the stream is of zlib or of gzip.
    if (inflateInit2(&stream_, 15 + 32) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  void restart() { inflateReset(&stream_); }
  std::optional<Step> step(std::span<std::uint8_t> in, std::span<std::uint8_t> out) {
    stream_.next_in = in.data(), stream_.avail_in = uInt(in.size());
    stream_.next_out = out.data(), stream_.avail_out = uInt(out.size());
    const int code = inflate(&stream_, Z_NO_FLUSH);
    if (code != Z_OK && code != Z_BUF_ERROR && code != Z_STREAM_END) return {};
    return Step{in.size() - stream_.avail_in, out.size() - stream_.avail_out, code == Z_STREAM_END};
  }

 private:
  z_stream stream_{};
};

class Bunzipper {
 public:
  Bunzipper() { start(); }
  ~Bunzipper() { BZ2_bzDecompressEnd(&stream_); }
  Bunzipper(const Bunzipper&) = delete;
  Bunzipper& operator=(const Bunzipper&) = delete;
  void restart() {
    BZ2_bzDecompressEnd(&stream_);
    stream_ = {};
    start();
  }
  std::optional<Step> step(std::span<std::uint8_t> in, std::span<std::uint8_t> out) {
    stream_.next_in = reinterpret_cast<char*>(in.data()), stream_.avail_in = unsigned(in.size());
    stream_.next_out = reinterpret_cast<char*>(out.data()), stream_.avail_out = unsigned(out.size());
    const int code = BZ2_bzDecompress(&stream_);
    if (code != BZ_OK && code != BZ_STREAM_END) return {};
    return Step{in.size() - stream_.avail_in, out.size() - stream_.avail_out, code == BZ_STREAM_END};
  }

 private:
  void start() {
    if (BZ2_bzDecompressInit(&stream_, 0, 0) != BZ_OK) throw std::bad_alloc();
  }
  bz_stream stream_{};
};

template <class Library>
void unpackWith(Library& library, const DataPart& part, std::uintmax_t bytes, const Sink& sink) {
  std::ifstream file(part.file, std::ios::binary);
  file.seekg(std::streamoff(part.offset));
  std::vector<std::uint8_t> in(kChunk), out(kChunk);
  std::span<std::uint8_t> input;
  std::uintmax_t left = part.bytes > 0 ? part.bytes : UINTMAX_MAX, unpacked = 0;
  bool ended = false;
  while (!ended || unpacked < bytes) {
    if (input.empty()) {
      file.read(reinterpret_cast<char*>(in.data()), std::streamsize(std::min<std::uintmax_t>(left, kChunk)));
      input = std::span(in).first(std::size_t(file.gcount()));
      left -= input.size();
      require(!input.empty(), "{} ends before all of its voxels; the copy is incomplete, get a fresh one.",
              part.header.string());
    }
    if (ended) library.restart();  // files may be several streams, one after another
    const std::optional<Step> step = library.step(input, out);
    if (!step || (step->taken == 0 && step->given == 0 && !step->ended)) failDamaged(part.header);
    input = input.subspan(step->taken);
    unpacked += step->given;
    sink(std::span<const std::uint8_t>(out).first(step->given));
    require(unpacked <= bytes + kChunk, "{} holds more than its header declares; get a fresh copy.",
            part.header.string());
    ended = step->ended;
  }
}

}  // namespace

bool isPacked(const fs::path& path) {
  const std::vector<std::uint8_t> start = readBytes(path, 2);
  return start.size() == 2 && start[0] == 0x1f && start[1] == 0x8b;
}

std::vector<std::uint8_t> unpackedStart(const fs::path& path, std::size_t bytes) {
  fileSize(path);
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  require(file != nullptr, "The file {} cannot be read; check its permissions.", path.string());
  std::vector<std::uint8_t> start(bytes);
  start.resize(std::size_t(std::max(0, gzread(file.get(), start.data(), unsigned(bytes)))));
  return start;
}

void unpack(const DataPart& part, Encoding encoding, std::uintmax_t bytes, const Sink& sink) {
  if (encoding == Encoding::bzip2) {
    Bunzipper library;
    return unpackWith(library, part, bytes, sink);
  }
  Inflater library;
  unpackWith(library, part, bytes, sink);
}

}  // namespace sonoskin
