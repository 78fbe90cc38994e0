#include "app/batch/mesh_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace sonoskin {

std::string factsJson(const MeshFacts& facts) {
  const MeshCheck& c = facts.check;
  nlohmann::ordered_json json;
  json["triangles"] = facts.triangles;
  json["vertices"] = c.usedVertices;
  json["pieces"] = facts.pieces;
  json["size_mm"] = {facts.size.x, facts.size.y, facts.size.z};
  json["area_mm2"] = facts.area;
  json["volume_mm3"] = c.closed() ? nlohmann::ordered_json(facts.volume) : nlohmann::ordered_json(nullptr);
  json["closed"] = c.closed();
  json["manifold"] = c.manifold();
  json["oriented"] = c.oriented();
  json["boundary_edges"] = c.boundaryEdges;
  json["degenerate_triangles"] = c.degenerateTriangles;
  json["self_intersections"] = facts.selfIntersections;
  json["euler"] = c.euler;
  json["printable"] = facts.printable();
  return json.dump(2);
}

std::string factsText(const MeshFacts& facts) {
  const MeshCheck& c = facts.check;
  std::string text = fmt::format("  triangles  {}, {} vertices, {} {}\n", facts.triangles, c.usedVertices,
                                 facts.pieces, facts.pieces == 1 ? "piece" : "pieces");
  text += fmt::format("  size       {:.1f} x {:.1f} x {:.1f} mm\n", facts.size.x, facts.size.y, facts.size.z);
  text += fmt::format("  area       {:.1f} cm2\n", facts.area / 100);
  text += c.closed() ? fmt::format("  volume     {:.2f} cm3\n", facts.volume / 1000) : "";
  text += fmt::format("  closed     {}\n",
                      c.closed() ? "yes" : fmt::format("no: {} sides at borders", c.boundaryEdges));
  text +=
      fmt::format("  manifold   {}\n", c.manifold() ? "yes"
                                                    : fmt::format("no: {} edges, {} vertices are not",
                                                                  c.nonManifoldEdges, c.nonManifoldVertices));
  text += fmt::format(
      "  oriented   {}\n",
      c.oriented() ? "yes" : fmt::format("no: {} edges between turned triangles", c.misorientedEdges));
  text += fmt::format("  crossing   {} pairs of triangles\n", facts.selfIntersections);
  text += fmt::format("  degenerate {} triangles\n", c.degenerateTriangles);
  text += fmt::format("  printable  {}\n", facts.printable() ? "yes" : "no");
  return text;
}

}  // namespace sonoskin
