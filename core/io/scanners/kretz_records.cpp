#include "core/io/scanners/kretz_records.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kMagic = "KRETZFILE 1.0   ", kAnyVersion = "KRETZFILE";
constexpr std::size_t kHead = 8;
constexpr KretzTag kEnd = kretzTag(0xFFFF, 0xFFFF);

bool startsWith(std::span<const std::uint8_t> bytes, std::string_view text) {
  return bytes.size() >= text.size() && std::memcmp(bytes.data(), text.data(), text.size()) == 0;
}

// Numbers lie in the file as they lie in the memory of every machine that this runs on: the lowest byte first.
template <class T>
T take(std::span<const std::uint8_t> bytes) {
  T value{};
  std::memcpy(&value, bytes.data(), std::min(bytes.size(), sizeof value));
  return value;
}

// What is read: the geometry, the voxels, and what says that they are packed. All else is passed over: groups 0110 to 0150
// name the patient, the hospital, the probe, the time and the machine.
bool isRead(KretzTag tag) {
  constexpr KretzTag tags[] = {kretzTag(0x0001, 0x0100), kretzTag(0x0010, 0x0022), kretzTag(0xC000, 1),
                               kretzTag(0xC000, 2),      kretzTag(0xC000, 3),      kretzTag(0xC100, 1),
                               kretzTag(0xC200, 1),      kretzTag(0xC200, 2),      kretzTag(0xC300, 1),
                               kretzTag(0xC300, 2),      kretzTag(0xD000, 1),      kretzTag(0xD400, 1),
                               kretzTag(0xD600, 1)};
  const KretzTag grey = tag >> 16 < 0xC000 ? tag : tag & ~KretzTag(0x0F00);
  return std::ranges::find(tags, grey) != std::end(tags);
}

// 0002,1000, 1100 and 1200, D100,0001 and D700.
bool isMarker(KretzTag tag) {
  return (tag & ~KretzTag(0x0F00)) == kretzTag(0x0002, 0x1000) ||
         (tag & ~KretzTag(0x0F00)) == kretzTag(0xD100, 0x0001) || tag >> 16 == 0xD700;
}

}  // namespace

KretzRecords::KretzRecords(std::span<const std::uint8_t> file, const fs::path& path) : path_(path) {
  require(startsWith(file, kAnyVersion),
          "{} is no GE Kretz file, though its name is that of one: other programs use the ending .vol too; "
          "export it as NRRD or MetaImage.",
          path.string());
  require(startsWith(file, kMagic),
          "{} is a GE Kretz file of a version that is not known here, and only 1.0 is; save it again with GE "
          "4D View, or export it as NRRD or DICOM.",
          path.string());
  std::span<const std::uint8_t> left = file.subspan(kMagic.size());
  while (left.size() >= kHead) {  // a few bytes more than records are padding, as inside of a DICOM
    const KretzTag tag = kretzTag(take<std::uint16_t>(left), take<std::uint16_t>(left.subspan(2)));
    const auto length = take<std::uint32_t>(left.subspan(4));
    if (tag == kEnd) return;
    left = left.subspan(kHead);
    require(length <= left.size(),
            "{} ends before all of its records; the copy is incomplete, get a fresh one.", path.string());
    if (isRead(tag)) add(tag, left.first(length));
    packed_ |= isMarker(tag);
    left = left.subspan(length);
  }
}

void KretzRecords::add(KretzTag tag, std::span<const std::uint8_t> bytes) {
  const auto [found, isNew] = records_.emplace(tag, bytes);
  require(isNew || std::ranges::equal(found->second, bytes),
          "{} holds record {:04X},{:04X} twice, with different contents; save it again with the program that "
          "it is from.",
          path_.string(), tag >> 16, tag & 0xFFFF);
}

std::span<const std::uint8_t> KretzRecords::bytesOf(KretzTag tag) const {
  const auto found = records_.find(tag);
  return found == records_.end() ? std::span<const std::uint8_t>{} : found->second;
}

std::optional<std::uint32_t> KretzRecords::wholeOf(KretzTag tag) const {
  if (!has(tag)) return {};
  const auto bytes = bytesOf(tag);
  require(!bytes.empty() && bytes.size() <= 4,
          "{} has a record {:04X},{:04X} that is no whole number; get a fresh copy.", path_.string(),
          tag >> 16, tag & 0xFFFF);
  return take<std::uint32_t>(bytes);
}

std::vector<double> KretzRecords::valuesOf(KretzTag tag, std::size_t most) const {
  const auto bytes = bytesOf(tag);
  require(bytes.size() % sizeof(double) == 0 && bytes.size() / sizeof(double) <= most,
          "{} has a record {:04X},{:04X} of another length than its numbers have; get a fresh copy.",
          path_.string(), tag >> 16, tag & 0xFFFF);
  std::vector<double> values(bytes.size() / sizeof(double));
  if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

std::optional<double> KretzRecords::valueOf(KretzTag tag) const {
  const std::vector<double> values = valuesOf(tag, 1);
  if (values.empty()) return {};
  return values.front();
}

}  // namespace sonoskin
