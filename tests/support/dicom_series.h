#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <string>

#include "core/base/log.h"
#include "core/io/volume_loader.h"
#include "tests/support/dicom.h"
#include "tests/support/temp_folder.h"

namespace sonoskin::test {

inline constexpr int kColumns = 12, kRows = 10;

// place: as DICOM writes it, in mm.
inline std::string place(const glm::dvec3& p) { return fmt::format("{:.6f}\\{:.6f}\\{:.6f}", p.x, p.y, p.z); }

// ramp: a slice whose numbers grow along the world's axes: 1000 + 10 x + 100 y + 30 z, x along rows and y along columns.
inline DicomImage ramp(int number, const glm::dvec3& origin) {
  DicomImage image;
  image.columns = kColumns, image.rows = kRows;
  image.number = number, image.position = place(origin);
  for (int j = 0; j < kRows; ++j)
    for (int i = 0; i < kColumns; ++i)
      image.numbers.push_back(
          int(std::lround(1000 + 10 * (origin.x + 0.5 * i) + 100 * (origin.y + 0.5 * j) + 30 * origin.z)));
  return image;
}

// SeriesFolder: a folder of slices.
struct SeriesFolder : TempFolder {
  void add(const std::string& name, const DicomImage& image) const { write(name, dicomFile(image)); }
  // Slices 2 mm apart, changed by `change(image, k)`.
  template <class Change>
  const std::filesystem::path& series(int count, const Change& change, const std::string& name = "s") const {
    for (int k = 0; k < count; ++k) {
      DicomImage image = ramp(k + 1, {0, 0, 2.0 * k});
      change(image, k);
      add(fmt::format("{}{:02}.dcm", name, k), image);
    }
    return path();
  }
};
inline const auto asIs = [](DicomImage&, int) {};

// numberAt: as it is stored.
inline double numberAt(const LoadedVolume& v, int i, int j, int k) {
  const std::size_t n = v.stored.geometry.index(i, j, k);
  if (v.stored.type == NumberType::float32) {
    float value;
    std::memcpy(&value, v.numbers.data() + 4 * n, 4);
    return double(value);
  }
  EXPECT_EQ(v.stored.type, NumberType::uint16);
  std::uint16_t value;
  std::memcpy(&value, v.numbers.data() + 2 * n, 2);
  return value;
}

// expectRamp: that every voxel that was recorded has the number of its place in the world; how many there are.
inline int expectRamp(const LoadedVolume& v) {
  const Geometry& g = v.stored.geometry;
  int recorded = 0;
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) {
        const glm::dvec3 w = g.toWorld({i, j, k});
        const double number = numberAt(v, i, j, k);
        if (std::isnan(number)) continue;
        EXPECT_NEAR(number, 1000 + 10 * w.x + 100 * w.y + 30 * w.z, 0.6) << i << " " << j << " " << k;
        ++recorded;
      }
  return recorded;
}

// warned: whether a warning has these words.
inline bool warned(const LogRecord& record, const char* words) {
  for (const std::string& sentence : record.sentences(LogLevel::warning))
    if (sentence.find(words) != std::string::npos) return true;
  return false;
}

}  // namespace sonoskin::test
