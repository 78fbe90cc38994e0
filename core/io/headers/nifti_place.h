#pragma once

#include <filesystem>

#include "core/io/headers/nifti_fields.h"
#include "core/io/stored_volume.h"

namespace sonoskin {

// placeNifti: where the voxels of a NIfTI lie.
//   output  stored.geometry but its dims, in mm and LPS; spacingKnown, stepSeconds
//   errors  Error: numbers that are no place; an axis without length
// The matrix (sform) holds where its code is set, as most programs have it: whoever moves or resamples a
// volume writes it, and its columns give the spacing too. Else the quaternion (qform) with pixdim, else
// pixdim alone [nifti1.h, methods 3, 2, 1].
void placeNifti(const NiftiFields& fields, StoredVolume& stored, const std::filesystem::path& path);

}  // namespace sonoskin
