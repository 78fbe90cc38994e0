#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/volume/volume.h"

namespace sonoskin {

// Directions: the normalised gradient g of the low-passed volume, in the cells between 2x2x2 voxels.
//   x, y, z  127 times g, per cell; cell (i,j,k) lies between voxels (i,j,k) and (i+1,j+1,k+1) and is stored
//            at voxel (i,j,k)'s index; 0 for the last i, j and k, which have no cell
struct Directions {
  Geometry geometry;
  std::vector<std::int8_t> x, y, z;
};

// cellDirections: g = grad v~ / sqrt(|grad v~|^2 + kappa^2), quantised.
//   kappa    gradient per smallest spacing below which a direction fades
//   errors   Cancelled
Directions cellDirections(const Volume<float>& lowPassed, double kappa, const Progress& progress = {});

// TangentialOperator: K u = -beta div(D grad u), D = |g|^2 I - g g^T: diffusion within the surfaces to which
// g is normal, none across. Natural borders. Lengths in units of the smallest spacing.
//   K = beta sum over cells G^T D G with the 2x2x2 cell gradient G: symmetric, positive semi-definite, and
//   zero on constants by construction, since D is made from the quantised g.
class TangentialOperator {
 public:
  TangentialOperator(std::shared_ptr<const Directions> directions, double beta);

  // forEachRow: calls row(j, k, Ku) with the dims.x values of K u for every row of voxels, in parallel over
  // slabs of k; the values do not depend on the number of threads.
  //   u        one value per voxel
  //   cost     reads u once and 3 bytes per voxel of directions; about 60 flops per voxel
  //   errors   Cancelled
  using Row = std::function<void(int j, int k, const float* ku)>;
  void forEachRow(const std::vector<float>& u, const Row& row, const Progress& progress = {}) const;

  // diagonalRow: the diagonal of K for one row of voxels.
  void diagonalRow(int j, int k, float* out) const;

  const Geometry& geometry() const { return directions_->geometry; }

 private:
  std::shared_ptr<const Directions> directions_;
  glm::vec3 scale_;  // smallest spacing / spacing
  float factor_;     // beta / (127^2 * 16): undoes the quantisation and both means over four edges
};

}  // namespace sonoskin
