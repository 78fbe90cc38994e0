#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/io/dicom/dicom_source.h"
#include "core/io/dicom/dicom_tags.h"

namespace sonoskin {

struct DicomItem;

// DicomElement: one that is taken [DICOM PS3.5, 7.1].
//   value      its bytes, little endian, where they are few
//   offset     of its bytes in the source, `length` of them
//   items      of a sequence
//   fragments  of packed pixels: offset and length of each, the table of offsets first
struct DicomElement {
  DicomTag tag = 0;
  std::array<char, 2> type{};
  std::uint64_t offset = 0, length = 0;
  std::string value;
  std::vector<DicomItem> items;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> fragments;
};

// DicomItem: a data set, or an item of a sequence. Every tag is there once.
struct DicomItem {
  std::vector<DicomElement> elements;

  const DicomElement* find(DicomTag tag) const;
  // item: the first one of a sequence, null where there is none. items: all.
  const DicomItem* item(DicomTag sequence) const;
  const std::vector<DicomItem>& items(DicomTag sequence) const;
  // numbers: all values that are finite numbers up to the first that is none. number: the one at a place.
  std::vector<double> numbers(DicomTag tag) const;
  std::optional<double> number(DicomTag tag, std::size_t place = 0) const;
  // whole: the same as a whole number; nothing where it is none that an int holds.
  std::optional<int> whole(DicomTag tag) const;
  // text: without the blanks around it. It is compared, and never shown.
  std::string text(DicomTag tag) const;
};

// DicomDataSet: what was taken from a file, and in which way its pixels are packed.
struct DicomDataSet {
  std::string syntax;  // the transfer syntax's UID
  bool bigEndian = false;
  std::uint64_t inflatedAt = 0;  // from where on the source is unpacked; 0: it is not
  DicomItem root;
};

// readDataSet: walks over all elements of a file, and takes those of dicom_tags.h.
//   output  every length that is told fits into the file
//   errors  Error: an element is longer than what is left of the file, the file ends within one, sequences are nested deeper
//           than 32, more than four million elements are to be taken
//   cost    one pass over the headers of elements; values that are not taken are passed over
// No library parses what this has not walked over: lengths that lie make GDCM take 4 GB of memory (CVE-2026-3650).
DicomDataSet readDataSet(DicomSource& source);

}  // namespace sonoskin
