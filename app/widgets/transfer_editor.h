#pragma once

#include <span>

#include "app/widgets/fields_ui.h"
#include "render/transfer_function.h"

namespace sonoskin::ui {

// TransferPlot: what the editor draws behind the curve.
//   histogram  heights over values from 0 to 1, 0 to 1
//   level      where skin begins, 0 to 1
struct TransferPlot {
  std::span<const float> histogram;
  float level = 0;
};

// editTransfer: opacity over grey as a curve, filled with its colours, before a histogram. A point is dragged; a click beside
// the points makes one; the right button, Delete or Backspace takes it away. Below, the selected point in numbers and its
// colour.
//   selected  the point that is selected, -1: none
FieldsEdit editTransfer(TransferFunction& transfer, const TransferPlot& plot, int& selected);

}  // namespace sonoskin::ui
