#pragma once

#include <filesystem>

#include "core/io/headers/declared_data.h"
#include "core/io/headers/meta_fields.h"

namespace sonoskin {

// placeMeta: where the voxels of a MetaImage lie.
//   input   data  its sizes, and which of its axes are space
//   output  stored.geometry in mm and LPS, spacingKnown, modality
//   errors  Error: a field does not have one finite number per axis; two fields that mean the same differ
// TransformMatrix holds one direction after another, that of the first axis first: a column of `direction` in
// each row of three.
void placeMeta(const MetaFields& meta, DeclaredData& data, const std::filesystem::path& path);

}  // namespace sonoskin
