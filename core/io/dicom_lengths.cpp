#include "core/io/dicom_lengths.h"

#include <cstdint>
#include <fstream>
#include <string_view>

#include "core/base/error.h"
#include "core/io/file_bytes.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::uint32_t kUndefined = 0xFFFFFFFF;
constexpr std::uint32_t kItem = 0xFFFEE000, kItemEnd = 0xFFFEE00D, kSequenceEnd = 0xFFFEE0DD;
constexpr std::uint32_t kPixelData = 0x7FE00010, kTransferSyntax = 0x00020010;

struct Element {
  std::uint32_t tag = 0, length = 0;
  bool sequence = false, unknown = false;
};

// Walks over the elements of a file as one flat list: sequences and items are entered, everything else is
// skipped.
class Walker {
 public:
  explicit Walker(const fs::path& path) : path_(path), left_(fileSize(path)), file_(path, std::ios::binary) {}

  void walk() {
    skip(132);  // preamble and magic
    while (left_ >= 8) {
      const Element e = next();
      if (e.tag == kTransferSyntax) {
        readSyntax(e.length);
        continue;
      }
      if (deflated_ && e.tag >> 16 != 2) return;
      if (e.tag == kItem || e.tag == kItemEnd || e.tag == kSequenceEnd) {
        // Items of packed pixels hold bytes, items of sequences hold elements.
        if (e.tag == kItem && inPixels_) skip(e.length);
        continue;
      }
      if (e.length == kUndefined) {
        if (e.unknown) return;  // its content has implicit types
        inPixels_ = e.tag == kPixelData;
        continue;
      }
      if (!e.sequence) skip(e.length);
    }
  }

 private:
  std::uint32_t number(int bytes) {
    unsigned char raw[4] = {};
    file_.read(reinterpret_cast<char*>(raw), bytes);
    left_ -= std::min<std::uintmax_t>(left_, std::uintmax_t(bytes));
    require(bool(file_), "{} ends within an element; the copy is incomplete, get a fresh one.",
            path_.string());
    std::uint32_t value = 0;
    for (int b = 0; b < bytes; ++b) value |= std::uint32_t(raw[big() ? bytes - 1 - b : b]) << (8 * b);
    return value;
  }
  bool big() const { return bigEndian_ && !inMeta_; }

  Element next() {
    Element e;
    inMeta_ = inMeta_ && peekGroup() == 2;
    const std::uint32_t group = number(2);
    e.tag = group << 16 | number(2);
    if (group == 0xFFFE || (implicit_ && !inMeta_)) {
      e.length = number(4);
      return e;
    }
    const char a = char(file_.get()), b = char(file_.get());
    left_ -= std::min<std::uintmax_t>(left_, 2);
    const char vr[2] = {a, b};
    const std::string_view type(vr, 2);
    e.sequence = type == "SQ";
    e.unknown = type == "UN";
    static constexpr std::string_view kLong = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
    if (kLong.find(type) == std::string_view::npos) {
      e.length = number(2);
    } else {
      number(2);
      e.length = number(4);
    }
    return e;
  }

  unsigned peekGroup() {
    const int low = file_.get(), high = file_.peek();
    file_.unget();
    return unsigned(low) | unsigned(high) << 8;
  }

  void skip(std::uint32_t bytes) {
    require(bytes <= left_,
            "{} has an element longer than the file; the copy is incomplete, get a fresh one.",
            path_.string());
    file_.seekg(bytes, std::ios::cur);
    left_ -= bytes;
  }

  void readSyntax(std::uint32_t length) {
    require(length <= 64 && length <= left_, "{} has a damaged header; get a fresh copy.", path_.string());
    std::string uid(length, '\0');
    file_.read(uid.data(), length);
    left_ -= length;
    while (!uid.empty() && (uid.back() == '\0' || uid.back() == ' ')) uid.pop_back();
    implicit_ = uid == "1.2.840.10008.1.2";
    bigEndian_ = uid == "1.2.840.10008.1.2.2";
    deflated_ = uid == "1.2.840.10008.1.2.1.99";
  }

  fs::path path_;
  std::uintmax_t left_;
  std::ifstream file_;
  bool inMeta_ = true, implicit_ = false, bigEndian_ = false, deflated_ = false, inPixels_ = false;
};

}  // namespace

void checkDicomLengths(const fs::path& path) { Walker(path).walk(); }

}  // namespace sonoskin
