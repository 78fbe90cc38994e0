#pragma once

#include "core/io/dicom/dicom_series.h"
#include "tests/fuzz/fuzz_input.h"

namespace sonoskin::fuzz {

// readDicom: reads all volumes of a path, and claims of each that it is whole and lies somewhere.
inline void readDicom(const std::filesystem::path& path) {
  const std::size_t count = std::max<std::size_t>(1, dicomVolumes(path).size());
  for (std::size_t v = 1; v <= std::min<std::size_t>(count, 3); ++v) {
    const LoadedVolume volume = readDicomSeries(path, {count > 1 ? int(v) : 0});
    const StoredVolume& s = volume.stored;
    const std::size_t numbers = s.geometry.voxels() * std::size_t(s.components);
    claim(volume.numbers.size() == numbers * numberTypeBytes(s.type), "a volume is whole");
    claim(s.padding.empty() || s.padding.size() == std::size_t(s.geometry.dims.z), "slices have paddings");
    claim(s.modality.size() == 2 || s.modality.empty(), "no text of the file is kept");
    StoredVolume checked = s;
    if (!s.grid) checkGeometry(checked, path);
  }
}

}  // namespace sonoskin::fuzz
