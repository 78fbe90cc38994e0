#include "core/rbf/global/global_block.h"

#include "core/rbf/brick.h"
#include "core/rbf/global/global_polynomial.h"
#include "core/rbf/global/global_system.h"

namespace sonoskin {
namespace {

constexpr double kNear = 2.5;  // half edges from the middle of the cube

Eigen::Map<const Eigen::VectorXd> vectorOf(const std::vector<double>& v) {
  return {v.data(), Eigen::Index(v.size())};
}

bool isNear(const glm::dvec3& p, const glm::dvec3& centre, double halfEdge) {
  const glm::dvec3 d = glm::abs(p - centre);
  return std::max({d.x, d.y, d.z}) < kNear * halfEdge;
}

// What the far centres and the polynomial give at the nodes of the cube.
ChebyshevCube farShare(const GlobalRbf::Parts& parts, const glm::dvec3& centre, double halfEdge) {
  Sites far, places;
  std::vector<double> weights;
  for (std::size_t i = 0; i < parts.centres.size(); ++i)
    if (!isNear(parts.centres[i], centre, halfEdge)) {
      far.push_back(parts.centres[i]);
      weights.push_back(parts.weights[i]);
    }
  for (std::size_t n = 0; n < ChebyshevCube::kSize; ++n)
    places.push_back(centre + halfEdge * ChebyshevCube::place(n));
  const Eigen::VectorXd sums = kernelSums(parts.kernel, far, vectorOf(weights), places);
  std::array<double, ChebyshevCube::kSize> values{};
  for (std::size_t n = 0; n < values.size(); ++n)
    values[n] = sums[Eigen::Index(n)] + polynomialValue(parts.polynomial, places[n]);
  return ChebyshevCube(values);
}

}  // namespace

GlobalBlock::GlobalBlock(const GlobalRbf::Parts& parts, const glm::dvec3& centre, double halfEdge)
    : centre_(centre), halfEdge_(halfEdge), kernel_(parts.kernel), far_(farShare(parts, centre, halfEdge)) {
  for (std::size_t i = 0; i < parts.centres.size(); ++i)
    if (isNear(parts.centres[i], centre, halfEdge)) {
      near_.push_back(parts.centres[i]);
      nearWeights_.push_back(parts.weights[i]);
    }
}

void GlobalBlock::values(const glm::dvec3& corner, double cell, std::span<float, 64> result) const {
  Sites nodes;
  for (std::size_t n = 0; n < kBrickNodes; ++n)
    nodes.push_back(corner + cell * glm::dvec3(nodePlace(int(n))));
  Eigen::VectorXd sums = kernelSums(kernel_, near_, vectorOf(nearWeights_), nodes);
  std::array<ChebyshevCube::Four, 3> along{};
  for (int axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < 4; ++i)
      along[std::size_t(axis)][i] = (corner[axis] + double(i) * cell - centre_[axis]) / halfEdge_;
  far_.addOnLattice(along[0], along[1], along[2], sums.data());
  for (std::size_t n = 0; n < kBrickNodes; ++n) result[n] = float(sums[Eigen::Index(n)]);
}

std::vector<glm::dvec3> GlobalBlock::gradients(const Sites& places) const {
  std::vector<glm::dvec3> result = kernelGradients(kernel_, near_, vectorOf(nearWeights_), places);
  for (std::size_t i = 0; i < places.size(); ++i)
    result[i] += far_.gradient((places[i] - centre_) / halfEdge_) / halfEdge_;
  return result;
}

}  // namespace sonoskin
