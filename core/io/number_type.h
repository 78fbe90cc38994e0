#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace sonoskin {

// NumberType: how a file stores one number.
enum class NumberType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };
constexpr std::array<const char*, 10> enumNames(NumberType) {
  return {"int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "float32", "float64"};
}

std::string_view numberTypeName(NumberType type);  // "uint8", ...
std::size_t numberTypeBytes(NumberType type);
// numberTypeOf: of the name that ITK and VTK use, such as "unsigned_char"; nothing where it is not known here.
std::optional<NumberType> numberTypeOf(std::string_view name);

}  // namespace sonoskin
