#include "app/texts/text_table.h"

namespace sonoskin {

std::array<std::span<const Text>, 15> textTables() {
  return {commonTexts(),  commandTexts(), stepTexts(),      panelTexts(),  widgetTexts(),
          helpTexts(),    fileTexts(),    parameterNames(), choiceTexts(), foundHelps(),
          surfaceHelps(), skinHelps(),    scanHelps(),      useTexts(),    messageTexts()};
}

}  // namespace sonoskin
