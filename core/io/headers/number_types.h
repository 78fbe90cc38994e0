#pragma once

#include <cstdint>

#include "core/io/stored_volume.h"

namespace sonoskin {

// visitNumber: calls visit(T{}) with a number of the C++ type that a stored type is.
template <class Visit>
decltype(auto) visitNumber(NumberType type, Visit&& visit) {
  switch (type) {
    case NumberType::int8:
      return visit(std::int8_t{});
    case NumberType::uint8:
      return visit(std::uint8_t{});
    case NumberType::int16:
      return visit(std::int16_t{});
    case NumberType::uint16:
      return visit(std::uint16_t{});
    case NumberType::int32:
      return visit(std::int32_t{});
    case NumberType::uint32:
      return visit(std::uint32_t{});
    case NumberType::int64:
      return visit(std::int64_t{});
    case NumberType::uint64:
      return visit(std::uint64_t{});
    case NumberType::float32:
      return visit(float{});
    case NumberType::float64:
      break;
  }
  return visit(double{});
}

}  // namespace sonoskin
