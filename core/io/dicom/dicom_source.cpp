#include "core/io/dicom/dicom_source.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>

#include "core/base/error.h"
#include "core/io/file_bytes.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kWindow = 1u << 14;

// Packed without a header of zlib's.
class Inflater {
 public:
  explicit Inflater(std::vector<std::uint8_t>& packed) {
    stream_.next_in = packed.data();
    stream_.avail_in = uInt(packed.size());
    ready_ = inflateInit2(&stream_, -MAX_WBITS) == Z_OK;
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  // Whether all was unpacked, to `most` bytes at most.
  bool unpack(std::vector<std::uint8_t>& out, std::size_t most) {
    std::uint8_t block[1 << 15];
    int code = ready_ ? Z_OK : Z_STREAM_ERROR;
    while (code == Z_OK && out.size() <= most) {
      stream_.next_out = block;
      stream_.avail_out = sizeof block;
      code = ::inflate(&stream_, Z_NO_FLUSH);
      out.insert(out.end(), block, block + (sizeof block - stream_.avail_out));
    }
    return code == Z_STREAM_END && out.size() <= most;
  }

 private:
  z_stream stream_{};
  bool ready_ = false;
};

}  // namespace

DicomSource::DicomSource(const fs::path& file, const fs::path& named)
    : onDisk_(file), path_(named), file_(file, std::ios::binary), size_(fileSize(file)) {
  require(bool(file_), "The file {} may not be read; check its permissions.", path_.string());
}

void DicomSource::check(std::uint64_t offset, std::uint64_t length) const {
  require(offset <= size_ && length <= size_ - offset,
          "{} ends within an element; the copy is incomplete, get a fresh one.", path_.string());
}

void DicomSource::fill(std::uint64_t offset) {
  windowAt_ = offset;
  window_.resize(std::size_t(std::min(kWindow, size_ - offset)));
  file_.clear();
  file_.seekg(std::streamoff(offset));
  file_.read(reinterpret_cast<char*>(window_.data()), std::streamsize(window_.size()));
  require(bool(file_), "The file {} cannot be read to its end; check the disk, or get a fresh copy.",
          path_.string());
}

void DicomSource::read(std::uint64_t offset, std::uint64_t length, std::uint8_t* out) {
  check(offset, length);
  if (length == 0) return;
  if (!inflated_.empty() && offset >= inflatedAt_) {
    std::memcpy(out, inflated_.data() + (offset - inflatedAt_), length);
    return;
  }
  if (length > kWindow) {
    file_.clear();
    file_.seekg(std::streamoff(offset));
    file_.read(reinterpret_cast<char*>(out), std::streamsize(length));
    require(bool(file_), "The file {} cannot be read to its end; check the disk, or get a fresh copy.",
            path_.string());
    return;
  }
  if (offset < windowAt_ || offset + length > windowAt_ + window_.size()) fill(offset);
  std::memcpy(out, window_.data() + (offset - windowAt_), length);
}

std::vector<std::uint8_t> DicomSource::read(std::uint64_t offset, std::uint64_t length) {
  check(offset, length);
  std::vector<std::uint8_t> bytes(length);
  read(offset, length, bytes.data());
  return bytes;
}

std::span<const std::uint8_t> DicomSource::view(std::uint64_t offset, std::uint64_t length) {
  check(offset, length);
  if (length == 0) return {};
  if (!inflated_.empty() && offset >= inflatedAt_)
    return std::span(inflated_).subspan(offset - inflatedAt_, length);
  if (!mapped_) map();
  return {mapped_.get() + offset, std::size_t(length)};
}

void DicomSource::map() {
  const std::size_t bytes = fileSize(onDisk_);
  const int file = ::open(onDisk_.c_str(), O_RDONLY | O_CLOEXEC);
  void* found = file < 0 ? MAP_FAILED : ::mmap(nullptr, bytes, PROT_READ, MAP_PRIVATE, file, 0);
  if (file >= 0) ::close(file);
  require(found != MAP_FAILED && bytes >= size_,
          "The file {} cannot be mapped into memory; copy it to another disk.", path_.string());
  mapped_ =
      std::shared_ptr<const std::uint8_t>(static_cast<const std::uint8_t*>(found),
                                          [found, bytes](const std::uint8_t*) { ::munmap(found, bytes); });
}

void DicomSource::inflate(std::uint64_t offset) {
  constexpr std::size_t kMost = 256u << 20;
  std::vector<std::uint8_t> packed = read(offset, size_ - offset), unpacked;
  require(packed.size() <= kMost && Inflater(packed).unpack(unpacked, kMost) && !unpacked.empty(),
          "{} is deflated and damaged, or unpacks to more than {} MB; get a fresh copy, or save it unpacked.",
          path_.string(), kMost >> 20);
  inflated_ = std::move(unpacked);
  inflatedAt_ = offset;
  size_ = offset + inflated_.size();
}

}  // namespace sonoskin
