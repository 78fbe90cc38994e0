#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// BorderOptions: how the border of a surface is drawn.
//   limit       values at ±limit and beyond are sure: smoothing leaves them
//   smoothing   mm over which the values are smoothed along the surface
//   narrow      mm; parts of the surface that are narrower, and hang on it by their side or a neck, go; 0: none
//   holes       mm across; gaps up to this size that the surface surrounds are closed; 0: none
struct BorderOptions {
  float limit = 0.5f, smoothing = 1, narrow = 0, holes = 0;
};

// Border: what becomes of the vertices.
//   keep       > 0 where the surface stays, for clipMesh
//   measured   0 (at the border, and in closed gaps) to 1, one per vertex
struct Border {
  std::vector<float> keep, measured;
};

// drawBorder: where a surface ends, by how well it is supported.
//   margins    one per vertex: > 0 where the surface is supported; ±limit and beyond: surely
//   isBeyond   one per vertex: whether nothing is known there; a gap with such a vertex stays open
//   method     smoothed along the surface; gaps closed; then an opening of mathematical morphology along the surface: what
//              is farther than narrow/2 from the border, and all within narrow/2 of that, by Dijkstra's distances along
//              edges that start where the border cuts them
//   cost       290 thousand vertices: 70 ms
//   errors     Cancelled
Border drawBorder(const Mesh& mesh, std::vector<float> margins, const std::vector<std::uint8_t>& isBeyond,
                  const BorderOptions& options, const Progress& progress = {});

}  // namespace sonoskin
