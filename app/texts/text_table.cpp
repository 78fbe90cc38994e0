#include "app/texts/text_table.h"

namespace sonoskin {

std::array<std::span<const Text>, 1> textTables() { return {commonTexts()}; }

}  // namespace sonoskin
