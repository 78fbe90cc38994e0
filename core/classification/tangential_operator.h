#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/classification/tiles.h"
#include "core/volume/volume.h"

namespace sonoskin {

// Directions: the normalised gradient g of the low-passed volume, in the cells between 2x2x2 voxels.
//   x, y, z  127 times g, per cell; cell (i,j,k) lies between voxels (i,j,k) and (i+1,j+1,k+1) and is stored
//            at voxel (i,j,k)'s index; 0 for the last i, j and k, which have no cell
struct Directions {
  Geometry geometry;
  LargeArray<std::int8_t> x, y, z;
};

// cellDirections: g = grad v~ / sqrt(|grad v~|^2 + kappa^2), quantised.
//   kappa    gradient per smallest spacing below which a direction fades
//   errors   Cancelled
Directions cellDirections(const Volume<float>& lowPassed, double kappa, const Progress& progress = {});

// TileRow: called with (j, k, Ku) for each row of a tile's voxels; Ku has one value per voxel of the row.
using TileRow = std::function<void(int j, int k, const float* ku)>;

// TangentialOperator: K u = -beta div(D grad u), D = |g|^2 I - g g^T: diffusion within the surfaces to which
// g is normal, none across. Natural borders. Lengths in units of the smallest spacing.
//   K = beta sum over cells G^T D G with the 2x2x2 cell gradient G: symmetric, positive semi-definite, and
//   zero on constants by construction, since D is made from the quantised g.
class TangentialOperator {
 public:
  TangentialOperator(std::shared_ptr<const Directions> directions, double beta);

  // apply: K u on the voxels of one tile.
  //   u        one value per voxel of the volume; read up to one voxel around the tile
  //   cost     about 60 flops per voxel and 80 per cell; 4 bytes of u and 3 of directions per voxel
  void apply(const float* u, const Tile& tile, const TileRow& row) const;

  // diagonalRow: the diagonal of K for the voxels (., j, k) of the volume.
  void diagonalRow(int j, int k, float* out) const;

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
