#include "app/texts/text_table.h"

namespace sonoskin {

std::array<std::span<const Text>, 16> textTables() {
  return {commonTexts(), commandTexts(),   stepTexts(),    panelTexts(), widgetTexts(),  helpTexts(),
          fileTexts(),   parameterNames(), choiceTexts(),  foundHelps(), surfaceHelps(), skinHelps(),
          scanHelps(),   useTexts(),       messageTexts(), outputTexts()};
}

}  // namespace sonoskin
