#pragma once

#include <array>

#include "core/base/fields.h"
#include "core/base/places.h"

namespace sonoskin {

// PieceChoice: which connected piece of the reconstructed surface is the result.
enum class PieceChoice { probe, largest, index, point, all };
constexpr std::array<const char*, 5> enumNames(PieceChoice) {
  return {"probe", "largest", "index", "point", "all"};
}

// PartsChoice: whether the surface is cut into parts, of which those of the baby are kept.
enum class PartsChoice { automatic, pieces, all };
constexpr std::array<const char*, 3> enumNames(PartsChoice) { return {"automatic", "pieces", "all"}; }

// MeshOptions: from the implicit function to the mesh.
struct MeshOptions {
  int resolution = 400;
  double cell = 0;
  double support = 1.0;
  double maxGap = 6;
  double density = 0.4;
  double narrowest = 6;
  PieceChoice piece = PieceChoice::probe;
  double companions = 0.08;
  int pieceIndex = 0;
  std::array<double, 3> piecePoint{0, 0, 0};
  double minArea = 0;
  double fillHoles = 25;
  int smoothing = 0;
  int triangles = 0;
  PartsChoice parts = PartsChoice::automatic;
  Places partsAdd, partsDrop, partsCut;
};

// cutsParts: whether the options ask for parts: all of them, or those of the piece in the probe's view.
inline bool cutsParts(const MeshOptions& o) {
  return o.parts == PartsChoice::all || (o.parts == PartsChoice::automatic && o.piece == PieceChoice::probe);
}

template <class F, class O>
requires OptionsOf<O, MeshOptions>
void fields(F&& f, O& o) {
  f(Field{"resolution", "cells along the longest side of the surface", "cells"}, o.resolution,
    Range{16, 2000});
  f(Field{"cell", "edge of a cell; 0: by the resolution", "mm"}, o.cell, Range{0.0, 20.0});
  f(Field{"support", "overlap of supports below which the surface is cut off", "", "tau"}, o.support,
    Range{0.0, 4.0});
  f(Field{"maxGap", "distance from the points beyond which the surface is cut off, in spacings of the points",
          "spacings"},
    o.maxGap, Range{1.0, 100.0});
  f(Field{"density", "share of the usual density of points below which the surface is cut off; 0: anywhere",
          "", "rho"},
    o.density, Range{0.0, 1.0});
  f(Field{"narrowest",
          "parts at the border that are narrower are cut off, in spacings of the points; 0: none",
          "spacings"},
    o.narrowest, Range{0.0, 50.0});
  f(Field{"piece", "probe: the piece most in the probe's view; largest: by area; index, point: see below"},
    o.piece);
  f(Field{"companions",
          "for piece = probe: parts or pieces that fill this share of the middle of its view are kept too; 1 "
          "keeps it alone"},
    o.companions, Range{0.0, 1.0});
  f(Field{"pieceIndex", "for piece = index: 0 is the piece with the largest area, 1 the next, ..."},
    o.pieceIndex, Range{0, 1000000});
  f(Field{"piecePoint", "for piece = point: the piece nearest to this point of the volume's frame", "mm"},
    o.piecePoint, Range{-1e5, 1e5});
  f(Field{"minArea", "pieces with a smaller area are dropped", "mm²"}, o.minArea, Range{0.0, 1e6});
  f(Field{"fillHoles", "holes inside the surface up to this size, measured across, are closed; 0: none",
          "mm"},
    o.fillHoles, Range{0.0, 1000.0});
  f(Field{"smoothing", "steps of smoothing that keep features and size", "steps"}, o.smoothing,
    Range{0, 200});
  f(Field{"triangles", "reduce the mesh to this many triangles; 0: all are kept", "triangles"}, o.triangles,
    Range{0, 100000000});
  f(Field{"parts",
          "automatic: the surface is cut where people would cut it, and the face and what belongs to the "
          "baby are "
          "kept, if piece = probe; pieces: whole connected pieces; all: every part is kept"},
    o.parts);
  f(Field{"partsAdd", "parts that are kept too: those nearest to these places", "mm"}, o.partsAdd,
    Range{-1e5, 1e5});
  f(Field{"partsDrop", "parts that are taken away: those nearest to these places", "mm"}, o.partsDrop,
    Range{-1e5, 1e5});
  f(Field{"partsCut",
          "strokes that split a part, three places each: begin and end on the surface, and the eye that drew "
          "it",
          "mm"},
    o.partsCut, Range{-1e5, 1e5});
}

}  // namespace sonoskin
