#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/base/error.h"

// The records of a KRETZFILE 1.0, as GE's Voluson machines write them: 16 bytes "KRETZFILE 1.0   ", then records of group,
// element (16 bits), length (32 bits) and that many bytes, little-endian, to the record FFFF,FFFF or the end of the file.
// Known from open readers alone (plooney/kretz, SlicerHeart).
namespace sonoskin {

// KretzTag: group in the upper, element in the lower half; bits 0F00 are the number of the volume.
using KretzTag = std::uint32_t;
constexpr KretzTag kretzTag(std::uint16_t group, std::uint16_t element, int volume = 0) {
  return std::uint32_t(group) << 16 | element | std::uint32_t(volume) << 8;
}

// KretzRecords: where the records that are read lie. Those that can name a patient are passed over and never kept.
class KretzRecords {
 public:
  // file  all of it; must outlive this
  //   errors  Error: not such a file, or a record that does not end within it
  KretzRecords(std::span<const std::uint8_t> file, const std::filesystem::path& path);

  bool has(KretzTag tag) const { return records_.contains(tag); }
  // packed: whether a record says that the voxels are packed by wavelets.
  bool packed() const { return packed_; }
  // bytesOf: what a record holds; empty where there is none.
  std::span<const std::uint8_t> bytesOf(KretzTag tag) const;
  // wholeOf: a record that is one whole number, of 1 to 4 bytes; nothing where there is none.
  //   errors  Error: it is empty or longer
  std::optional<std::uint32_t> wholeOf(KretzTag tag) const;
  // knownWholeOf: the same of a record of which little is known: nothing too where it is longer.
  std::optional<std::uint32_t> knownWholeOf(KretzTag tag) const {
    return bytesOf(tag).size() <= 4 && !bytesOf(tag).empty() ? wholeOf(tag) : std::nullopt;
  }
  // valuesOf: a record of 64-bit floating-point numbers; empty where there is none.
  //   errors  Error: it is no whole count of them, or more than `most`
  std::vector<double> valuesOf(KretzTag tag, std::size_t most) const;
  // valueOf: the same of a record that is one number.
  std::optional<double> valueOf(KretzTag tag) const;

  const std::filesystem::path& path() const { return path_; }

 private:
  void add(KretzTag tag, std::span<const std::uint8_t> bytes);

  std::filesystem::path path_;
  std::map<KretzTag, std::span<const std::uint8_t>> records_;
  bool packed_ = false;
};

}  // namespace sonoskin
