// Words that many places share.

#include "app/texts/text_table.h"

namespace sonoskin {
namespace {

// clang-format off
const Text kTexts[] = {
  {"Cancel", "Abbrechen", "Annuler"},
};
// clang-format on

}  // namespace

std::span<const Text> commonTexts() { return kTexts; }

}  // namespace sonoskin
