#pragma once

#include <array>
#include <type_traits>

#include "core/base/fields.h"
#include "core/base/hash.h"

namespace sonoskin {

// addOptions: folds every field of an options struct into the fingerprint, by name and value.
template <class Options>
void addOptions(Hasher& hasher, const Options& options) {
  fields(
      [&](const Field& field, const auto& member, auto...) {
        hasher.add(field.name);
        if constexpr (std::is_arithmetic_v<std::decay_t<decltype(member)>> ||
                      std::is_enum_v<std::decay_t<decltype(member)>>) {
          hasher.add(member);
        } else {
          for (const auto& value : member) hasher.add(value);
        }
      },
      options);
}

}  // namespace sonoskin
