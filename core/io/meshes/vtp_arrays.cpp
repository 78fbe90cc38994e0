#include "core/io/meshes/vtp_arrays.h"

#include <libdeflate.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <memory>
#include <optional>

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/header_text.h"
#include "core/io/meshes/base64.h"
#include "core/io/meshes/xml_elements.h"

namespace sonoskin {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers of big-endian files are turned round");

// The letters that so many bytes take.
std::size_t lettersOf(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

template <class T>
void append(std::vector<double>& to, std::string_view bytes, bool isBigEndian) {
  to.reserve(bytes.size() / sizeof(T));
  for (std::size_t at = 0; at + sizeof(T) <= bytes.size(); at += sizeof(T)) {
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes.data() + at, sizeof(T));
    if (isBigEndian) std::reverse(raw.begin(), raw.end());
    to.push_back(double(std::bit_cast<T>(raw)));
  }
}

using Append = void (*)(std::vector<double>&, std::string_view, bool);

Append appendOf(std::string_view type) {
  static const std::map<std::string_view, Append> kTypes{
      {"Int8", append<std::int8_t>},     {"UInt8", append<std::uint8_t>},   {"Int16", append<std::int16_t>},
      {"UInt16", append<std::uint16_t>}, {"Int32", append<std::int32_t>},   {"UInt32", append<std::uint32_t>},
      {"Int64", append<std::int64_t>},   {"UInt64", append<std::uint64_t>}, {"Float32", append<float>},
      {"Float64", append<double>},       {"String", append<std::uint8_t>}};
  const auto found = kTypes.find(type);
  return found == kTypes.end() ? nullptr : found->second;
}

}  // namespace

VtkXmlFile::VtkXmlFile(const std::filesystem::path& path, std::string_view type)
    : path_(path), file_(readBytes(path)) {
  const std::string_view bytes(reinterpret_cast<const char*>(file_.data()), file_.size());
  const std::size_t end = bytes.find("<AppendedData");
  if (end == std::string_view::npos) {
    parse(bytes, type);
    return;
  }
  // What follows need not be text: it begins behind the mark.
  const std::size_t tag = bytes.find('>', end),
                    mark = tag == std::string_view::npos ? tag : bytes.find('_', tag);
  check(mark != std::string_view::npos);
  appendedIsBase64_ = bytes.substr(end, tag - end).find("base64") != std::string_view::npos;
  appended_ = bytes.substr(mark + 1);
  parse(std::string(bytes.substr(0, end)) + "</VTKFile>", type);
}

void VtkXmlFile::check(bool holds) const {
  require(
      holds,
      "{} is damaged or incomplete: its arrays are not what it says; get a fresh copy, or save it as PLY.",
      path_.string());
}

// HeaderWalk: what the elements of the header say, one after another.
class VtkXmlFile::HeaderWalk {
 public:
  HeaderWalk(VtkXmlFile& file, std::string_view type) : file_(file), type_(type) {}

  void walk(std::string_view xml) {
    XmlEvents events;
    events.begin = [&](const XmlElement& e) { begin(e); };
    events.text = [&](std::string_view text) {
      if (array_ && inArray_ == 0) array_->text += text;
    };
    events.end = [&](std::string_view) {
      if (array_ && inArray_-- == 0) array_ = nullptr;
    };
    walkXml(xml, events, file_.path_);
    require(found_, "{} is no XML file of VTK; get a fresh copy, or save it as PLY.", file_.path_.string());
  }

 private:
  void begin(const XmlElement& e) {
    static constexpr std::array<std::string_view, 8> kSections{"FieldData", "PointData", "CellData", "Points",
                                                               "Verts",     "Lines",     "Strips",   "Polys"};
    const std::string_view name = e.name();
    if (array_) {
      ++inArray_;  // something about the array
    } else if (name == "VTKFile") {
      beginFile(e);
    } else if (name == "Piece") {
      file_.pieces_.emplace_back();
      for (const char* count : {"NumberOfPoints", "NumberOfVerts", "NumberOfLines"})
        file_.pieces_.back().attributes[count] = valueOf(e, count);
    } else if (name == "DataArray" || name == "Array") {
      beginArray(e);
    } else if (std::ranges::count(kSections, name) > 0) {
      section_ = name;
      if (file_.pieces_.empty()) return;
      for (const char* role : {"Normals", "TCoords"})
        if (const auto named = e.value(role)) file_.pieces_.back().attributes[section_ + "." + role] = *named;
    }
  }

  void beginFile(const XmlElement& e) {
    found_ = true;
    require(valueOf(e, "type") == type_, "{} is an XML file of VTK of another kind; save it as {}.",
            file_.path_.string(), type_);
    file_.isBigEndian_ = valueOf(e, "byte_order") == "BigEndian";
    file_.wordBytes_ = valueOf(e, "header_type") == "UInt64" ? 8 : 4;
    const std::string packing = valueOf(e, "compressor");
    file_.isPacked_ = !packing.empty();
    require(!file_.isPacked_ || packing == "vtkZLibDataCompressor",
            "{} is packed by LZ4 or LZMA, which is not read here; save it with zlib, or unpacked.",
            file_.path_.string());
  }

  void beginArray(const XmlElement& e) {
    const auto number = [&](std::string_view name, std::size_t otherwise) {
      const auto text = e.value(name);
      const auto value = text ? parseNumber<std::size_t>(trimmed(*text)) : otherwise;
      file_.check(value.has_value());
      return *value;
    };
    const bool isField = section_ == "FieldData" || file_.pieces_.empty();
    std::vector<VtkXmlArray>& arrays = isField ? file_.fields_ : file_.pieces_.back().arrays;
    arrays.push_back({section_,
                      valueOf(e, "Name"),
                      valueOf(e, "type"),
                      valueOf(e, "format"),
                      {},
                      number("NumberOfComponents", 1),
                      number("offset", 0)});
    array_ = &arrays.back();
    inArray_ = 0;
  }

  static std::string valueOf(const XmlElement& e, std::string_view name) {
    return std::string(e.value(name).value_or(""));
  }

  VtkXmlFile& file_;
  std::string_view type_;
  std::string section_;
  VtkXmlArray* array_ = nullptr;
  int inArray_ = 0;
  bool found_ = false;
};

void VtkXmlFile::parse(std::string_view xml, std::string_view type) { HeaderWalk(*this, type).walk(xml); }

// One of the words in front of an array's bytes.
std::uint64_t VtkXmlFile::word(std::string_view bytes, std::size_t index) const {
  check(bytes.size() / wordBytes_ > index);
  std::array<char, 8> raw{};
  std::memcpy(raw.data(), bytes.data() + index * wordBytes_, wordBytes_);
  if (isBigEndian_) std::reverse(raw.begin(), raw.begin() + std::ptrdiff_t(wordBytes_));
  return std::bit_cast<std::uint64_t>(raw);
}

namespace {

// The first `count` bytes that letters stand for; nothing where there are fewer.
std::optional<std::string> decoded(std::string_view letters, std::size_t count) {
  if (count > letters.size() || lettersOf(count) > letters.size()) return {};
  const auto bytes = fromBase64(letters.substr(0, lettersOf(count)));
  if (!bytes || bytes->size() < count) return {};
  return std::string(bytes->begin(), bytes->begin() + std::ptrdiff_t(count));
}

}  // namespace

// A count of bytes and these. As letters both are one, or, as some programs write them, each ends by itself.
std::string VtkXmlFile::plain(std::string_view stored, bool isBase64) const {
  if (!isBase64) {
    const std::uint64_t count = word(stored, 0);
    check(count <= stored.size() - wordBytes_);
    return std::string(stored.substr(wordBytes_, count));
  }
  const std::size_t head = lettersOf(wordBytes_);
  check(stored.size() >= head);
  if (stored[wordBytes_ == 4 ? head - 2 : head - 1] == '=') {
    const auto first = decoded(stored, wordBytes_);
    check(first.has_value());
    auto rest = decoded(stored.substr(head), word(*first, 0));
    check(rest.has_value());
    return std::move(*rest);
  }
  const auto first = fromBase64(stored.substr(0, head));
  check(first.has_value());
  const std::uint64_t count = word({reinterpret_cast<const char*>(first->data()), first->size()}, 0);
  check(count <= stored.size());
  const auto whole = decoded(stored, wordBytes_ + count);
  check(whole.has_value());
  return whole->substr(wordBytes_);
}

// The count of blocks, the bytes of each and of the last one unpacked, those of each packed; then the blocks.
std::string VtkXmlFile::unpacked(std::string_view stored, bool isBase64) const {
  constexpr std::size_t kMostGrowth = 1032;  // of deflate, for each packed byte
  const auto head = [&](std::size_t words) {
    const auto bytes =
        isBase64 ? decoded(stored, words * wordBytes_) : std::string(stored.substr(0, words * wordBytes_));
    check(bytes && bytes->size() == words * wordBytes_);
    return *bytes;
  };
  const std::string first = isBase64 ? head(3) : head(1);
  const std::uint64_t blocks = word(first, 0);
  check(blocks <= stored.size() / wordBytes_);
  if (blocks == 0) return {};
  const std::string facts = head(3 + blocks);
  const std::uint64_t size = word(facts, 1), last = word(facts, 2);
  std::string_view packed = stored.substr(isBase64 ? lettersOf(facts.size()) : facts.size());
  std::uint64_t packedBytes = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    check(word(facts, 3 + b) <= packed.size() - std::min<std::uint64_t>(packedBytes, packed.size()));
    packedBytes += word(facts, 3 + b);
  }
  const auto letters = isBase64 ? decoded(packed, packedBytes) : std::nullopt;
  check(!isBase64 || letters.has_value());
  if (letters) packed = *letters;
  const std::uint64_t most = kMostGrowth * packedBytes, final = last > 0 ? last : size;
  check(final <= size && final <= most &&
        (blocks == 1 || blocks - 1 <= (most - final) / std::max<std::uint64_t>(size, 1)));
  std::string bytes;
  const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> inflater(
      libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  for (std::size_t b = 0, at = 0; b < blocks; at += word(facts, 3 + b++)) {
    const std::size_t wanted = b + 1 == blocks ? final : size, before = bytes.size();
    bytes.resize(before + wanted);
    check(libdeflate_zlib_decompress(inflater.get(), packed.data() + at, word(facts, 3 + b),
                                     bytes.data() + before, wanted, nullptr) == LIBDEFLATE_SUCCESS);
  }
  return bytes;
}

std::string VtkXmlFile::bytesOf(const VtkXmlArray& array) const {
  const bool isAppended = array.format == "appended";
  std::string_view stored = isAppended ? appended_ : trimmed(array.text);
  check(isAppended || array.format == "binary");
  check(!isAppended || array.offset <= stored.size());
  if (isAppended) stored.remove_prefix(array.offset);
  const bool isBase64 = !isAppended || appendedIsBase64_;
  return isPacked_ ? unpacked(stored, isBase64) : plain(stored, isBase64);
}

std::vector<double> VtkXmlFile::numbers(const VtkXmlArray& array) const {
  const Append add = appendOf(array.type);
  check(add != nullptr);
  std::vector<double> values;
  if (array.format == "ascii" || array.format.empty()) {
    auto parsed = parseNumbers<double>(array.text);
    check(parsed.has_value());
    return std::move(*parsed);
  }
  add(values, bytesOf(array), isBigEndian_);
  return values;
}

}  // namespace sonoskin
