#include "core/io/dicom/dicom_data_set.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/io/header_text.h"

namespace sonoskin {
namespace {

template <class T>
void appendBinary(const std::string& value, std::vector<double>& out) {
  for (std::size_t at = 0; at + sizeof(T) <= value.size(); at += sizeof(T)) {
    T number;
    std::memcpy(&number, value.data() + at, sizeof(T));
    if (!std::isfinite(double(number))) return;
    out.push_back(double(number));
  }
}

void appendText(std::string_view text, std::vector<double>& out) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\\'), text.size());
    const auto number = parseNumber<double>(trimmed(text.substr(0, end)));
    if (!number || !std::isfinite(*number)) return;
    out.push_back(*number);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace

const DicomElement* DicomItem::find(DicomTag tag) const {
  const auto found = std::ranges::find(elements, tag, &DicomElement::tag);
  return found == elements.end() ? nullptr : &*found;
}

const std::vector<DicomItem>& DicomItem::items(DicomTag sequence) const {
  static const std::vector<DicomItem> none;
  const DicomElement* element = find(sequence);
  return element ? element->items : none;
}

const DicomItem* DicomItem::item(DicomTag sequence) const {
  const auto& all = items(sequence);
  return all.empty() ? nullptr : &all.front();
}

std::vector<double> DicomItem::numbers(DicomTag tag) const {
  std::vector<double> all;
  const DicomElement* element = find(tag);
  if (!element) return all;
  const std::string_view type(element->type.data(), 2);
  if (type == "US" || type == "XS")
    appendBinary<std::uint16_t>(element->value, all);
  else if (type == "SS")
    appendBinary<std::int16_t>(element->value, all);
  else if (type == "UL")
    appendBinary<std::uint32_t>(element->value, all);
  else if (type == "SL")
    appendBinary<std::int32_t>(element->value, all);
  else if (type == "FL")
    appendBinary<float>(element->value, all);
  else if (type == "FD")
    appendBinary<double>(element->value, all);
  else if (type == "AT")
    appendBinary<std::uint16_t>(element->value, all);  // group and element, one after the other
  else {
    std::string text = element->value;
    std::replace(text.begin(), text.end(), '\0', ' ');
    appendText(text, all);
  }
  return all;
}

std::optional<double> DicomItem::number(DicomTag tag, std::size_t place) const {
  const std::vector<double> all = numbers(tag);
  return place < all.size() ? std::optional(all[place]) : std::nullopt;
}

std::optional<int> DicomItem::whole(DicomTag tag) const {
  const auto found = number(tag);
  if (!found || *found != std::floor(*found) || std::abs(*found) > 2e9) return {};
  return int(*found);
}

std::string DicomItem::text(DicomTag tag) const {
  const DicomElement* element = find(tag);
  if (!element) return {};
  std::string text = element->value;
  std::replace(text.begin(), text.end(), '\0', ' ');
  return std::string(trimmed(text));
}

}  // namespace sonoskin
