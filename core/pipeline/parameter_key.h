#pragma once

#include <array>
#include <type_traits>

#include "core/base/fields.h"
#include "core/base/hash.h"
#include "core/base/places.h"

namespace sonoskin {

// addPlaces: folds a list of places into the fingerprint.
inline void addPlaces(Hasher& hasher, const Places& places) {
  hasher.add(places.size());
  for (const auto& place : places) hasher.add(std::span<const double>(place));
}

// addOptions: folds every field of an options struct into the fingerprint, by name and value.
template <class Options>
void addOptions(Hasher& hasher, const Options& options) {
  fields(
      [&](const Field& field, const auto& member, auto...) {
        hasher.add(field.name);
        if constexpr (std::is_arithmetic_v<std::decay_t<decltype(member)>> ||
                      std::is_enum_v<std::decay_t<decltype(member)>>) {
          hasher.add(member);
        } else if constexpr (std::is_same_v<std::decay_t<decltype(member)>, Places>) {
          addPlaces(hasher, member);
        } else {
          for (const auto& value : member) hasher.add(value);
        }
      },
      options);
}

}  // namespace sonoskin
