#include "core/io/number_type.h"

#include <map>

namespace sonoskin {

std::string_view numberTypeName(NumberType type) { return enumNames(type)[std::size_t(type)]; }

std::size_t numberTypeBytes(NumberType type) {
  constexpr std::array<std::size_t, 10> bytes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return bytes[std::size_t(type)];
}

std::optional<NumberType> numberTypeOf(std::string_view name) {
  static const std::map<std::string_view, NumberType> types{
      {"char", NumberType::int8},          {"unsigned_char", NumberType::uint8},
      {"short", NumberType::int16},        {"unsigned_short", NumberType::uint16},
      {"int", NumberType::int32},          {"unsigned_int", NumberType::uint32},
      {"long", NumberType::int64},         {"unsigned_long", NumberType::uint64},
      {"long_long", NumberType::int64},    {"unsigned_long_long", NumberType::uint64},
      {"vtktypeint64", NumberType::int64}, {"vtktypeuint64", NumberType::uint64},
      {"float", NumberType::float32},      {"double", NumberType::float64}};
  const auto found = types.find(name);
  if (found == types.end()) return {};
  return found->second;
}

}  // namespace sonoskin
