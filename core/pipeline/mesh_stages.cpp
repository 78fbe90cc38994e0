#include "core/pipeline/mesh_stages.h"

#include "core/base/error.h"
#include "core/mesh/components.h"
#include "core/mesh/print/print_solid.h"
#include "core/pipeline/choose_piece.h"
#include "core/pipeline/face_use.h"
#include "core/rbf/surface/iso_surface.h"

namespace sonoskin {
namespace {

using Pieces = std::vector<Mesh>;

Keyed<FittedSurface> fitPoints(const StageContext& c, const Keyed<FoundPoints>& found) {
  return c.run.stage<FittedSurface>(c.shares.fit, fitKey(found.key, c.parameters), [&](const Progress& p) {
    return fitSurface(*found.value->points, c.parameters.reconstruction, c.parameters.global, p);
  });
}

Keyed<Pieces> meshFit(const StageContext& c, const Keyed<FittedSurface>& fit, const SurfacePoints& points) {
  const MeshOptions& options = c.parameters.mesh;
  return c.run.stage<Pieces>(c.shares.pieces, piecesKey(fit.key, options), [&](const Progress& p) {
    const ImplicitFunction function = fit.value->function(meshCell(points.positions, options));
    return splitPieces(extractIsoSurface(function, points, options, p));
  });
}

Keyed<PartedSurface> cutPieces(const StageContext& c, const Keyed<Pieces>& pieces) {
  const MeshOptions& options = c.parameters.mesh;
  return c.run.stage<PartedSurface>(c.shares.parts, partsKey(pieces.key, options), [&](const Progress& p) {
    return partSurface(*pieces.value, options, p);
  });
}

glm::dvec3 centreOf(const Geometry& g) { return g.toWorld(0.5 * glm::dvec3(g.dims - 1)); }

Keyed<KeptParts> keptOfParts(const StageContext& c, const MeshInput& in, const Keyed<PartedSurface>& parts) {
  const Parameters& parameters = c.parameters;
  return c.run.stage<KeptParts>(
      c.shares.kept, keptKey(parts.key, in.face.key, parameters), [&](const Progress& p) {
        const PartView view{in.beam, centreOf(c.scan.volume->geometry), parameters.mesh.companions,
                            siteOf(in.face.value.get(), parameters.face)};
        return keepAsAsked(*parts.value, parameters.mesh, view, p);
      });
}

Keyed<KeptParts> keptOfPieces(const StageContext& c, const MeshInput& in, const Keyed<Pieces>& pieces) {
  return c.run.stage<KeptParts>(
      c.shares.kept, keptKey(pieces.key, in.face.key, c.parameters), [&](const Progress&) {
        const glm::dvec3 middle = centreOf(c.scan.volume->geometry);
        return KeptParts{choosePiece(*pieces.value, c.parameters.mesh, in.beam, middle), {}};
      });
}

Keyed<Mesh> cleanKept(const StageContext& c, const Keyed<KeptParts>& kept) {
  const MeshOptions& options = c.parameters.mesh;
  const Key key = cleanKey(kept.key, options);
  if (!needsCleaning(options)) return {{kept.value, &kept.value->mesh}, key};
  return c.run.stage<Mesh>(c.shares.mesh, key,
                           [&](const Progress& p) { return cleanMesh(kept.value->mesh, options, p); });
}

// The parts or pieces that were asked for.
Keyed<KeptParts> keep(const StageContext& c, const MeshInput& in, const Keyed<Pieces>& pieces,
                      Results& results) {
  if (!cutsParts(c.parameters.mesh)) return keptOfPieces(c, in, pieces);
  const Keyed<PartedSurface> parts = cutPieces(c, pieces);
  Keyed<KeptParts> kept = keptOfParts(c, in, parts);
  results.parts = parts.value;
  results.verdicts = {kept.value, &kept.value->verdicts};
  return kept;
}

void requirePoints(const SurfacePoints& points, const Results& results) {
  require(points.size() > 0 || results.warnings.empty(), "no surface was found: {}",
          results.warnings.empty() ? "" : results.warnings.front());
  require(points.size() > 0,
          "no surface was found: move classification.isoValue (now {:.2f}) toward the grey of the skin's "
          "edge, or lower surface.minClusterArea",
          results.isoValue);
}

}  // namespace

Key makeMesh(const StageContext& c, const MeshInput& in, Results& results) {
  const SurfacePoints& points = *in.found.value->points;
  requirePoints(points, results);
  const Keyed<FittedSurface> fit = fitPoints(c, in.found);
  results.centres = fit.value->centres;
  results.globalError = fit.value->report.globalError;
  results.globalErrorWithWeights = fit.value->report.globalErrorWithWeights;
  const Keyed<Pieces> pieces = meshFit(c, fit, points);
  results.pieces = pieces.value;
  const Keyed<Mesh> mesh = cleanKept(c, keep(c, in, pieces, results));
  results.mesh = mesh.value;
  const PrintOptions& print = c.parameters.print;
  if (print.form != PrintForm::none)
    results.print = c.run
                        .stage<Mesh>(c.shares.print, printKey(mesh.key, print),
                                     [&](const Progress& p) { return makePrintSolid(*mesh.value, print, p); })
                        .value;
  return mesh.key;
}

}  // namespace sonoskin
