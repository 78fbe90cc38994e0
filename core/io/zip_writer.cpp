#include "core/io/zip_writer.h"

#include <zlib.h>

#include <new>

#include "core/base/error.h"
#include "core/io/byte_sink.h"

namespace sonoskin {
namespace {

constexpr std::uint16_t kVersion = 20, kDeflated = 8;
constexpr std::uint16_t kDate = (2000 - 1980) << 9 | 1 << 5 | 1;  // 1 January 2000

struct Entry {
  std::string name;
  std::uint32_t crc, packed, unpacked, offset;
};

// Deflate without the zlib header, as ZIP wants it.
std::vector<std::uint8_t> deflated(const std::string& content) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  std::vector<std::uint8_t> packed(deflateBound(&stream, uLong(content.size())));
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
  stream.avail_in = uInt(content.size());
  stream.next_out = packed.data();
  stream.avail_out = uInt(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

// The fields that the header before a file and its entry in the directory have in common.
void putCommon(ByteSink& out, const Entry& e) {
  out.number(kVersion);
  out.number(std::uint16_t(0));  // no flags
  out.number(kDeflated);
  out.number(std::uint16_t(0));  // midnight
  out.number(kDate);
  out.number(e.crc);
  out.number(e.packed);
  out.number(e.unpacked);
  out.number(std::uint16_t(e.name.size()));
  out.number(std::uint16_t(0));  // nothing extra
}

void putDirectory(ByteSink& out, const std::vector<Entry>& entries) {
  const std::size_t begin = out.size();
  for (const Entry& e : entries) {
    out.text("PK\1\2");
    out.number(kVersion);
    putCommon(out, e);
    for (int n = 0; n < 3; ++n) out.number(std::uint16_t(0));  // no comment, first disk, not text
    out.number(std::uint32_t(0));                              // no attributes
    out.number(e.offset);
    out.text(e.name);
  }
  const std::size_t end = out.size();
  out.text("PK\5\6");
  out.number(std::uint32_t(0));  // one disk
  for (int n = 0; n < 2; ++n) out.number(std::uint16_t(entries.size()));
  out.number(std::uint32_t(end - begin));
  out.number(std::uint32_t(begin));
  out.number(std::uint16_t(0));  // no comment
}

}  // namespace

std::vector<std::uint8_t> zipFiles(const std::vector<std::pair<std::string, std::string>>& files) {
  ByteSink out;
  std::vector<Entry> entries;
  for (const auto& [name, content] : files) {
    require(content.size() + out.size() < 0xF0000000u,
            "The surface is too large for this format; write PLY instead.");
    const std::vector<std::uint8_t> packed = deflated(content);
    const auto crc = crc32(0, reinterpret_cast<const Bytef*>(content.data()), uInt(content.size()));
    entries.push_back({name, std::uint32_t(crc), std::uint32_t(packed.size()), std::uint32_t(content.size()),
                       std::uint32_t(out.size())});
    out.text("PK\3\4");
    putCommon(out, entries.back());
    out.text(name);
    out.array(packed);
  }
  putDirectory(out, entries);
  return out.take();
}

}  // namespace sonoskin
