#include "core/classification/iso_value.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/volume/gaussian.h"
#include "core/volume/sample.h"

namespace sonoskin {
namespace {

constexpr double kSamples = 230'000;  // about so many voxels are looked at, evenly spread
constexpr float kMargin = 6;          // voxels from the recording's side, whose edge the low-pass blurs
constexpr double kEdgeShare = 0.02;   // of them the steepest count as edges
constexpr float kFacing = 0.3f;       // least cosine between gradient and beam at an edge of the skin
constexpr float kBefore = 4;          // mm before an edge, where fluid must be
constexpr float kCell = 4;            // mm: cells of the field
constexpr double kAround = 8;         // mm: standard deviation of the mean over edges around
constexpr double kFewEdges =
    0.02;  // of the weight in the richest places: what the whole volume's grey weighs

constexpr float kBlack = 0.02f;  // grey: a few steps of 8-bit data after the low-pass
constexpr float kSomeBlack = 0.35f,
                kAllBlack = 0.7f;          // shares of black fluid from which it counts, and counts in full
constexpr double kShareInBlack = 1 / 3.0;  // of the share that noisy fluid needs

struct Sample {
  float grey, gradient;
  glm::ivec3 voxel;
  bool facing;       // dark to bright along the beam
  float before = 0;  // grey a way before it on the beam
};

Sample sampleAt(const Volume<float>& volume, const Beam& beam, const glm::ivec3& voxel) {
  const Geometry& g = volume.geometry;
  const std::size_t index = g.index(voxel.x, voxel.y, voxel.z);
  const glm::vec3 gradient = gradientAt(volume, g.axisScale(), index);
  const glm::vec3 along(glm::transpose(g.direction) * beam.directionAt(g.toWorld(glm::dvec3(voxel))));
  const float length = glm::length(gradient);
  const glm::vec3 before = glm::vec3(voxel) - kBefore * along / glm::vec3(g.spacing);
  return {volume.data[index], length, voxel, glm::dot(gradient, along) > kFacing * length,
          sampleTrilinear(volume, before)};
}

std::vector<Sample> takeSamples(const Volume<float>& volume, const FieldOfView& view, const Beam& beam) {
  const Geometry& g = volume.geometry;
  const int stride = std::max(1, int(std::cbrt(double(g.voxels()) / kSamples)));
  const int slices = (g.dims.z - 2 + stride - 1) / stride;
  const auto margin = kMargin * float(g.minSpacing());
  std::vector<std::vector<Sample>> perSlice(std::size_t(std::max(0, slices)));
  parallelFor(slices, [&](std::ptrdiff_t slice) {
    const int k = 1 + int(slice) * stride;
    for (int j = 1; j < g.dims.y - 1; j += stride)
      for (int i = 1; i < g.dims.x - 1; i += stride) {
        const glm::vec3 position = glm::vec3(i, j, k) * glm::vec3(g.spacing);
        if (view.contains(position) && view.depth(position) >= margin)
          perSlice[std::size_t(slice)].push_back(sampleAt(volume, beam, {i, j, k}));
      }
  });
  std::vector<Sample> samples;
  for (const auto& some : perSlice) samples.insert(samples.end(), some.begin(), some.end());
  return samples;
}

// The gradient that all but the steepest samples stay below.
float steep(const std::vector<Sample>& samples) {
  std::vector<float> gradients;
  gradients.reserve(samples.size());
  for (const Sample& s : samples) gradients.push_back(s.gradient);
  const auto border = gradients.begin() + std::ptrdiff_t((1 - kEdgeShare) * double(gradients.size() - 1));
  std::nth_element(gradients.begin(), border, gradients.end());
  return *border;
}

// The mean of `value` over the samples, each with its weight; `otherwise` where nothing has weight.
template <class Weight, class Value>
double meanOf(const std::vector<Sample>& samples, double otherwise, const Weight& weight,
              const Value& value) {
  double sum = 0, weights = 0;
  for (const Sample& s : samples) {
    const double w = weight(s);
    sum += w * value(s), weights += w;
  }
  return weights > 0 ? sum / weights : otherwise;
}

// The weighted sums over the cells' samples, as two volumes of cells.
struct CellSums {
  Volume<float> weight, grey;
};

CellSums sumOverCells(const std::vector<Sample>& samples, const EdgeField& field, const Geometry& g,
                      const GreyLevels& levels) {
  Geometry cells;
  cells.dims = field.cells;
  cells.spacing = glm::dvec3(field.voxels) * g.spacing;
  CellSums sums{Volume<float>(cells), Volume<float>(cells)};
  const float dark = levels.between(0.5);
  for (const Sample& s : samples) {
    if (!s.facing || s.before > dark) continue;
    const glm::ivec3 cell = glm::min(glm::ivec3(glm::vec3(s.voxel) / field.voxels), field.cells - 1);
    const float weight = s.gradient * s.gradient;
    sums.weight.at(cell.x, cell.y, cell.z) += weight;
    sums.grey.at(cell.x, cell.y, cell.z) += weight * s.grey;
  }
  return sums;
}

std::shared_ptr<const EdgeField> edgesAround(const std::vector<Sample>& samples, const Geometry& g,
                                             const GreyLevels& levels) {
  auto field = std::make_shared<EdgeField>();
  field->cells = glm::max(glm::ivec3(1), glm::ivec3(glm::dvec3(g.dims) * g.spacing / double(kCell)));
  field->voxels = glm::vec3(g.dims) / glm::vec3(field->cells);
  CellSums sums = sumOverCells(samples, *field, g, levels);
  const double sigma = kAround / sums.weight.geometry.minSpacing();
  sums.weight = gaussianBlur(sums.weight, sigma);
  sums.grey = gaussianBlur(sums.grey, sigma);
  const float most = *std::ranges::max_element(sums.weight.data);
  if (!(most > 0)) return nullptr;
  const float few = float(kFewEdges) * most;
  for (std::size_t c = 0; c < sums.weight.data.size(); ++c)
    field->grey.push_back((sums.grey.data[c] + few * levels.edge) / (sums.weight.data[c] + few));
  return field;
}

// CellPair: the two cells between whose middles a voxel lies, and how far it is from the first.
struct CellPair {
  int first, second;
  float part;
};
CellPair cellsAround(int voxel, float size, int count) {
  const float at = std::clamp((float(voxel) + 0.5f) / size - 0.5f, 0.f, float(count - 1));
  const int first = std::min(int(at), count - 1);
  return {first, std::min(first + 1, count - 1), at - float(first)};
}

// What an iso-value's share of the way is multiplied with where so much of the fluid is black.
double factorFor(float black) {
  return std::lerp(1.0, kShareInBlack,
                   std::clamp(double((black - kSomeBlack) / (kAllBlack - kSomeBlack)), 0.0, 1.0));
}

}  // namespace

void EdgeField::row(int j, int k, int count, float* out) const {
  const CellPair y = cellsAround(first.y + j, voxels.y, cells.y),
                 z = cellsAround(first.z + k, voxels.z, cells.z);
  thread_local std::vector<float> line;
  line.resize(std::size_t(cells.x));
  const auto at = [&](int x, int b, int c) {
    return grey[(std::size_t(c) * std::size_t(cells.y) + std::size_t(b)) * std::size_t(cells.x) +
                std::size_t(x)];
  };
  for (int x = 0; x < cells.x; ++x) {
    const float near = std::lerp(at(x, y.first, z.first), at(x, y.second, z.first), y.part);
    const float far = std::lerp(at(x, y.first, z.second), at(x, y.second, z.second), y.part);
    line[std::size_t(x)] = std::lerp(near, far, z.part);
  }
  for (int i = 0; i < count; ++i) {
    const CellPair x = cellsAround(first.x + i, voxels.x, cells.x);
    const float a = line[std::size_t(x.first)];
    out[i] = a + x.part * (line[std::size_t(x.second)] - a);
  }
}

float GreyLevels::between(double share) const {
  return std::clamp(fluid + float(share) * (edge - fluid), 0.02f, 0.98f);
}

float GreyLevels::iso(double share) const { return between(share * factorFor(black)); }

void GreyLevels::isoRow(double share, int j, int k, int count, float* out) const {
  if (!edges) {
    std::fill_n(out, count, iso(share));
    return;
  }
  edges->row(j, k, count, out);
  const auto part = float(share * factorFor(black));
  for (int i = 0; i < count; ++i) out[i] = std::clamp(fluid + part * (out[i] - fluid), 0.02f, 0.98f);
}

IsoRange isoRangeOf(const GreyLevels& levels, double share) {
  IsoRange range{double(levels.fluid), double(levels.edge)};
  range.least = range.most = double(levels.iso(share));
  if (!levels.edges) return range;
  const auto [low, high] = std::ranges::minmax_element(levels.edges->grey);
  GreyLevels local = levels;
  local.edge = *low, range.least = double(local.iso(share));
  local.edge = *high, range.most = double(local.iso(share));
  return range;
}

GreyLevels proposeLevels(const Volume<float>& lowPassed, const FieldOfView& view, const Beam& beam) {
  GreyLevels levels;
  const std::vector<Sample> samples = takeSamples(lowPassed, view, beam);
  if (samples.empty()) return levels;
  const float least = steep(samples);
  const auto grey = [](const Sample& s) { return double(s.grey); };
  const auto isEdge = [&](const Sample& s) {
    return s.facing && s.gradient >= least ? double(s.gradient) : 0.0;
  };
  levels.edge = float(meanOf(samples, 0.5, isEdge, grey));
  const auto isDark = [&](const Sample& s) { return s.grey < levels.edge ? 1.0 : 0.0; };
  levels.fluid = float(meanOf(samples, 0, isDark, grey));
  levels.black =
      float(meanOf(samples, 0, isDark, [](const Sample& s) { return s.grey < kBlack ? 1.0 : 0.0; }));
  levels.edges = edgesAround(samples, lowPassed.geometry, levels);
  return levels;
}

}  // namespace sonoskin
