#include "core/pipeline/choose_piece.h"

#include <stdexcept>

#include "core/base/error.h"
#include "core/mesh/components.h"

namespace sonoskin {
namespace {

// The pieces that fill at least `share` of the view that the best one fills: a face and, say, the shoulders beyond
// a shadow.
Mesh piecesInView(const std::vector<Mesh>& pieces, const std::vector<double>& shares, double share) {
  std::vector<Mesh> chosen;
  for (std::size_t p = 0; p < pieces.size(); ++p)
    if (shares[p] >= share) chosen.push_back(pieces[p]);
  return joinPieces(chosen);
}

}  // namespace

Mesh choosePiece(const std::vector<Mesh>& pieces, const MeshOptions& options, const Beam& beam,
                 const glm::dvec3& middle) {
  require(!pieces.empty(), "the surface is empty: lower mesh.support or raise mesh.maxGap");
  switch (options.piece) {
    case PieceChoice::probe:
      return piecesInView(pieces, viewShares(pieces, beam, middle), options.companions);
    case PieceChoice::largest:
      return pieces.front();
    case PieceChoice::index:
      require(std::size_t(options.pieceIndex) < pieces.size(),
              "mesh.pieceIndex is {}, but the surface has {} pieces, numbered from 0", options.pieceIndex,
              pieces.size());
      return pieces[std::size_t(options.pieceIndex)];
    case PieceChoice::point:
      return pieces[pieceNearest(pieces,
                                 {options.piecePoint[0], options.piecePoint[1], options.piecePoint[2]})];
    case PieceChoice::all:
      return joinPieces(pieces);
  }
  throw std::logic_error("unknown PieceChoice");
}

}  // namespace sonoskin
