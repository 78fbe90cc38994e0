#pragma once

#include <string>

#include "app/workspace/view_state.h"

namespace sonoskin {

// writeViews: what view_fields.h lists, as a JSON object.
std::string writeViews(const ViewState& view);

// marksKey: of the measures that a person has set; a zero key where there are none.
Key marksKey(const ViewState& view);

// readViews: sets what the text names and leaves the rest, and what cannot be used: views are no reason to refuse a session.
// Numbers are brought within their ranges.
void readViews(const std::string& json, ViewState& view);

}  // namespace sonoskin
