#include "core/pipeline/kept_parts.h"

#include "core/base/error.h"
#include "core/mesh/components.h"
#include "core/mesh/parts/keep_parts.h"
#include "core/mesh/parts/split_part.h"

namespace sonoskin {
namespace {

glm::vec3 vec(const std::array<double, 3>& place) { return {place[0], place[1], place[2]}; }

}  // namespace

PartedSurface partSurface(const std::vector<Mesh>& pieces, const MeshOptions& options,
                          const Progress& progress) {
  require(!pieces.empty(), "the surface is empty: lower mesh.support or raise mesh.maxGap");
  PartedSurface surface{joinPieces(pieces), {}};
  surface.parts = cutParts(surface.mesh, progress.part(0, 0.8));
  const Places& cut = options.partsCut;
  for (std::size_t i = 0; i + 2 < cut.size(); i += 3) {
    splitPart(surface.mesh, surface.parts, {vec(cut[i]), vec(cut[i + 1]), vec(cut[i + 2])});
    progress.update(0.8 + 0.2 * double(i + 3) / double(cut.size()));
  }
  return surface;
}

KeptParts keepAsAsked(const PartedSurface& surface, const MeshOptions& options, const PartView& view,
                      const Progress& progress) {
  PartView asked = view;
  for (const auto& place : options.partsDrop)
    asked.dropped.push_back(partAt(surface.mesh, surface.parts, vec(place)));
  KeptParts result;
  result.verdicts = chooseParts(surface.mesh, surface.parts, asked);
  progress.update(0.4);
  const auto bringBack = [](PartVerdict& v, PartReason reason) {
    if (!v.kept && v.reason != PartReason::dropped) v.kept = true, v.reason = reason;
  };
  if (options.parts == PartsChoice::all)
    for (PartVerdict& v : result.verdicts) {
      bringBack(v, PartReason::all);
      v.proposed = true;
    }
  for (const auto& place : options.partsAdd)
    bringBack(result.verdicts[partAt(surface.mesh, surface.parts, vec(place))], PartReason::asked);
  result.mesh = keepParts(surface.mesh, surface.parts, result.verdicts, progress.part(0.5, 1));
  require(!result.mesh.empty(), "every part of the surface is taken away: bring one back (mesh.partsDrop)");
  return result;
}

}  // namespace sonoskin
