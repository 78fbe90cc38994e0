#include "app/workspace/document_view.h"

namespace sonoskin {

void beginDocument(ViewState& view) {
  view.orientation = {};
  view.measures.clear();
  view.measureBegun.reset();
  view.grey = {};
}

}  // namespace sonoskin
