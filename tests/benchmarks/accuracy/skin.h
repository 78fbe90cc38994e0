#pragma once

#include "core/pipeline/parameters.h"

namespace sonoskin::accuracy {

// printSkinTables: how far the light of the skin's passes is from the integral over the surface, as Markdown.
void printSkinTables(const Parameters& parameters);

}  // namespace sonoskin::accuracy
