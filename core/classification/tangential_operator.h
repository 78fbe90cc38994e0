#pragma once

#include <memory>

#include "core/classification/directions.h"
#include "core/classification/tiles.h"

namespace sonoskin {

// TangentialOperator: the term beta |grad u x g|^2, a NeighbourTerm (operator_sum.h): K u = -beta div(D grad u),
// D = |g|^2 I - g g^T: diffusion within the surfaces to which g is normal, none across.
//   K = beta sum over cells G^T D G with the 2x2x2 cell gradient G: symmetric, positive semi-definite, and
//   zero on constants by construction, since D is made from the quantised g.
class TangentialOperator {
 public:
  TangentialOperator(std::shared_ptr<const Directions> directions, double beta);

  // apply: K u on the voxels of one tile.
  //   u        one value per voxel of the volume; read up to one voxel around the tile
  //   cost     about 60 flops per voxel and 80 per cell; 4 bytes of u and 3 of directions per voxel
  void apply(const float* u, const Tile& tile, const TileRow& row) const;

  // addDiagonalRow: adds the diagonal of K for the voxels (., j, k) of the volume to `out`.
  void addDiagonalRow(int j, int k, float* out) const;

  // largestEigenvalue: no eigenvalue of K scaled to a unit diagonal is larger, as far as cells are alike around a
  // voxel: 8 max over unit n of lambda_max(S D S) / trace(S D S), S: smallest spacing / spacing. 4 for cubic
  // voxels, up to 8 for flat ones.
  double largestEigenvalue() const;

  const Geometry& geometry() const { return directions_->geometry; }

 private:
  std::shared_ptr<const Directions> directions_;
  glm::vec3 scale_;  // smallest spacing / spacing
  float factor_;     // beta / (127^2 * 16): undoes the quantisation and both means over four edges
};

}  // namespace sonoskin
