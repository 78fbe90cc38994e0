#include "core/base/parallel.h"
#include "core/skin/beckmann.h"
#include "core/skin/skin_material.h"

namespace sonoskin {
namespace {

SpecularTable computeTable() {
  SpecularTable table;
  table.value.resize(size_t(SpecularTable::kCosines * SpecularTable::kRoughnesses));
  table.mean.resize(size_t(SpecularTable::kRoughnesses));
  parallelFor(SpecularTable::kRoughnesses, [&](std::ptrdiff_t row) {
    const double share = double(row) / (SpecularTable::kRoughnesses - 1);
    const double m = SpecularTable::kLeast + (SpecularTable::kMost - SpecularTable::kLeast) * share;
    for (int i = 0; i < SpecularTable::kCosines; ++i) {
      const double cosine = double(i) / (SpecularTable::kCosines - 1);
      table.value[size_t(row * SpecularTable::kCosines + i)] = float(directionalAlbedo(cosine, m));
    }
    table.mean[size_t(row)] = float(meanAlbedo(m));
  });
  return table;
}

}  // namespace

const SpecularTable& specularTable() {
  static const SpecularTable table = computeTable();
  return table;
}

}  // namespace sonoskin
