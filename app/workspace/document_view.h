#pragma once

#include "app/workspace/view_state.h"

namespace sonoskin {

// beginDocument: what belongs to the document in a view state begins anew: whose planes there are, turns, measures, the grey
// window.
void beginDocument(ViewState& view);

}  // namespace sonoskin
