// The walk over the elements of a file.
#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "core/io/dicom/dicom_data_set.h"
#include "core/io/header_text.h"

namespace sonoskin {
namespace {

constexpr std::uint64_t kShortValue = 1u << 18;
constexpr int kDeepest = 32, kMostElements = 4'000'000;
constexpr std::array<char, 2> kPresence{'-', '-'};  // of an element whose content is not taken
constexpr std::uint32_t kUndefined = 0xFFFF'FFFF;

// Coding: how elements are written.
struct Coding {
  bool typed = true, bigEndian = false;
};

struct Head {
  DicomTag tag = 0;
  std::array<char, 2> type{};
  std::uint32_t length = 0;
  std::string_view typeName() const { return {type.data(), 2}; }
};

// Bytes that change places where the byte order does.
std::size_t wordBytes(std::string_view type) {
  if (type == "US" || type == "SS" || type == "OW" || type == "AT") return 2;
  if (type == "UL" || type == "SL" || type == "FL" || type == "OF" || type == "OL") return 4;
  if (type == "FD" || type == "OD" || type == "OV" || type == "UV" || type == "SV") return 8;
  return 1;
}

class Parser {
 public:
  explicit Parser(DicomSource& source) : source_(source) {}

  DicomDataSet parse() {
    at_ = 132;  // preamble and magic
    DicomDataSet set;
    set.syntax = readSyntax();
    Coding coding{set.syntax != "1.2.840.10008.1.2", set.syntax == "1.2.840.10008.1.2.2"};
    if (set.syntax.empty()) coding.typed = looksTyped();
    if (set.syntax == "1.2.840.10008.1.2.1.99") source_.inflate(set.inflatedAt = at_);
    set.bigEndian = coding.bigEndian;
    walk(coding, source_.size(), false, &set.root);
    return set;
  }

 private:
  [[noreturn]] void damaged(const char* why) const {
    throw Error(fmt::format("{} {}; get a fresh copy.", source_.path().string(), why));
  }
  std::uint32_t number(int bytes, bool bigEndian) {
    std::uint8_t raw[4] = {};
    source_.read(at_, std::uint64_t(bytes), raw);
    at_ += std::uint64_t(bytes);
    std::uint32_t value = 0;
    for (int b = 0; b < bytes; ++b) value |= std::uint32_t(raw[bigEndian ? bytes - 1 - b : b]) << (8 * b);
    return value;
  }

  // The group in front of the data set, which is always typed and little endian; gives the transfer syntax.
  std::string readSyntax() {
    DicomItem meta;
    while (source_.size() - at_ >= 8) {
      std::uint8_t group[2];
      source_.read(at_, 2, group);
      if (group[0] != 2 || group[1] != 0) break;
      takeOrSkip({}, source_.size(), &meta);
    }
    return meta.text(tag::kTransferSyntax);
  }
  bool looksTyped() {
    std::uint8_t head[6] = {};
    if (source_.size() - at_ >= 6) source_.read(at_, 6, head);
    const auto isCapital = [](std::uint8_t c) { return c >= 'A' && c <= 'Z'; };
    return isCapital(head[4]) && isCapital(head[5]);
  }

  Head next(const Coding& coding) {
    Head head;
    const std::uint32_t group = number(2, coding.bigEndian);
    head.tag = group << 16 | number(2, coding.bigEndian);
    if (group == 0xFFFE || !coding.typed) {
      head.length = number(4, coding.bigEndian);
      const std::string_view type = dicomType(head.tag);
      if (!type.empty()) std::copy_n(type.begin(), 2, head.type.begin());
      return head;
    }
    source_.read(at_, 2, reinterpret_cast<std::uint8_t*>(head.type.data()));
    at_ += 2;
    constexpr std::string_view kLong = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
    const bool isLong = kLong.find(head.typeName()) != std::string_view::npos;
    if (isLong) at_ += 2;
    head.length = number(isLong ? 4 : 2, coding.bigEndian);
    return head;
  }

  // Elements up to `end`, or, where the length is not told, up to the end of their item.
  void walk(const Coding& coding, std::uint64_t end, bool delimited, DicomItem* into) {
    if (++depth_ > kDeepest) damaged("has sequences in sequences, deeper than any file needs");
    const auto creators = std::exchange(creators_, {});
    bool closed = !delimited;
    while (at_ <= end && end - at_ >= 8 && !(delimited && (closed = itemEnds(coding))))
      takeOrSkip(coding, end, into);
    if (!closed) damaged("ends within a sequence");
    creators_ = creators;
    if (!delimited) at_ = end;
    --depth_;
  }
  // Whether the end of an item comes next, which is passed over.
  bool itemEnds(const Coding& coding) {
    const std::uint64_t before = at_;
    const std::uint32_t group = number(2, coding.bigEndian);
    const bool ends = (group << 16 | number(2, coding.bigEndian)) == tag::kItemEnd;
    at_ = ends ? before + 8 : before;
    return ends;
  }

  void takeOrSkip(const Coding& coding, std::uint64_t end, DicomItem* into) {
    const Head head = next(coding);
    if (at_ > end) damaged("ends within an element");
    Head taken = head;
    const DicomTag name = into ? nameOf(taken, *into) : 0;
    DicomElement* element = name ? add(name, taken, *into) : nullptr;
    if (taken.type == kPresence) element = nullptr;
    // What is of unknown type has none within either [DICOM PS3.5, 6.2.2, note 5].
    const Coding within = head.typeName() == "UN" ? Coding{false, false} : coding;
    if (head.length == kUndefined) {
      const bool isPixels = head.tag == tag::kPixels || head.typeName() == "OB" || head.typeName() == "OW";
      isPixels ? fragments(coding, end, element) : sequence(within, end, true, element);
      return;
    }
    if (head.length > end - at_)
      damaged("has an element longer than what is left of it, as an incomplete copy has");
    const std::uint64_t after = at_ + head.length;
    if (element && taken.typeName() == "SQ")
      sequence(within, after, false, element);
    else if (element)
      takeValue(within, taken, *element);
    at_ = after;
  }

  // Under which tag an element is taken, 0 where it is not; gives it the type that it is taken as.
  DicomTag nameOf(Head& head, const DicomItem& into) {
    std::string_view type = dicomType(head.tag);
    DicomTag name = head.tag;
    if (reservesBlock(head.tag)) {
      reserve(head);
      return 0;
    }
    if ((head.tag >> 16) % 2 == 1 && (head.tag & 0xFFFF) >= 0x1000) {
      const auto creator = creators_.find((head.tag >> 16) << 8 | (head.tag >> 8 & 0xFF));
      if (creator == creators_.end()) return 0;
      const PrivateElement known = privateElement(creator->second, head.tag);
      type = known.type, name = known.name;
    }
    if (type.empty() || into.find(name)) return 0;
    // Numbers and words are as the file has them; only what it calls unknown is as the standard has it.
    const bool unknown = head.type[0] == '\0' || head.typeName() == "UN" || type == "XS";
    if (unknown && head.typeName() != "SS") std::copy_n(type.begin(), 2, head.type.begin());
    if (type == "UN")
      head.type = kPresence;
    else if ((type == "SQ") != (head.typeName() == "SQ"))
      return 0;
    return name;
  }
  void reserve(const Head& head) {
    if (head.length > 64 || head.length > source_.size() - at_) return;
    std::string creator(head.length, '\0');
    source_.read(at_, head.length, reinterpret_cast<std::uint8_t*>(creator.data()));
    std::erase(creator, '\0');
    creators_[(head.tag >> 16) << 8 | (head.tag & 0xFF)] = std::string(trimmed(creator));
  }

  DicomElement* add(DicomTag name, const Head& head, DicomItem& into) {
    if (++taken_ > kMostElements) damaged("has more elements than any file needs");
    DicomElement& element = into.elements.emplace_back();
    element.tag = name, element.type = head.type;
    return &element;
  }
  void takeValue(const Coding& coding, const Head& head, DicomElement& element) {
    element.offset = at_, element.length = head.length;
    if (head.length > kShortValue || element.tag == tag::kPixels) return;
    element.value.resize(head.length);
    source_.read(at_, head.length, reinterpret_cast<std::uint8_t*>(element.value.data()));
    const std::size_t word = coding.bigEndian ? wordBytes(head.typeName()) : 1;
    for (std::size_t w = 0; word > 1 && w + word <= element.value.size(); w += word)
      std::reverse(element.value.begin() + std::ptrdiff_t(w),
                   element.value.begin() + std::ptrdiff_t(w + word));
  }

  void sequence(const Coding& coding, std::uint64_t end, bool delimited, DicomElement* into) {
    while (end - at_ >= 8) {
      const Head head = next({false, coding.bigEndian});
      if (head.tag == tag::kSequenceEnd && delimited) return;
      if (head.tag != tag::kItem) damaged("has a sequence that is damaged");
      const bool open = head.length == kUndefined;
      if (!open && head.length > end - at_) damaged("has an item longer than its sequence");
      if (into && ++taken_ > kMostElements) damaged("has more items than any file needs");
      DicomItem* item = into ? &into->items.emplace_back() : nullptr;
      if (open || item)
        walk(coding, open ? end : at_ + head.length, open, item);
      else
        at_ += head.length;
    }
    if (delimited) damaged("ends within a sequence");
  }

  void fragments(const Coding& coding, std::uint64_t end, DicomElement* into) {
    while (end - at_ >= 8) {
      const Head head = next({false, coding.bigEndian});
      if (head.tag == tag::kSequenceEnd) return;
      if (head.tag != tag::kItem || head.length > end - at_)
        damaged("has packed pixels that are damaged, or ends within them");
      if (into && ++taken_ > kMostElements) damaged("has more items than any file needs");
      if (into) into->fragments.emplace_back(at_, head.length);
      at_ += head.length;
    }
    damaged("ends within its packed pixels");
  }

  DicomSource& source_;
  std::uint64_t at_ = 0;
  int depth_ = 0, taken_ = 0;
  std::map<std::uint32_t, std::string> creators_;  // of the item at hand, by group and block
};

}  // namespace

DicomDataSet readDataSet(DicomSource& source) { return Parser(source).parse(); }

}  // namespace sonoskin
