#pragma once

#include "core/io/scanners/kretz_records.h"
#include "core/io/stored_volume.h"

namespace sonoskin {

// kretzDims: samples along the beam, beams of the fan and pictures of the sweep, of volume v of a file.
//   errors  Error: there are none, or fewer than 2 along an axis
glm::ivec3 kretzDims(const KretzRecords& records, int v);

// describeKretz: the geometry of volume v: a grid of samples where the file has the angles of beams, else voxels. What volume
// v does not say itself is that of the grey one.
//   errors  Error: what is missing, or cannot be
void describeKretz(const KretzRecords& records, int v, StoredVolume& stored);

}  // namespace sonoskin
