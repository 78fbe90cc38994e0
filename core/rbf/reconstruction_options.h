#pragma once

#include "core/base/fields.h"

namespace sonoskin {

// ReconstructionOptions: adaptive compactly supported radial basis functions (Ohtake, Belyaev, Seidel 2004).
struct ReconstructionOptions {
  double smoothness = 5e-5;
  double overlap = 1.5;
  int neighbours = 10;
  double maxSupport = 0.07;
  bool fitWeights = false;
  double regularisation = 1e-4;
};

template <class F, class O>
requires OptionsOf<O, ReconstructionOptions>
void fields(F&& f, O& o) {
  f(Field{"smoothness", "1e-5 keeps detail and noise, 1e-4 is smooth", "", "T_sa"}, o.smoothness,
    Range{1e-6, 1e-3, true});
  f(Field{"overlap", "supports that must cover every point, at least", "", "T_overlap"}, o.overlap,
    Range{0.5, 4.0});
  f(Field{"neighbours", "neighbours that measure the density around a point", "", "K"}, o.neighbours,
    Range{3, 50});
  f(Field{"maxSupport", "largest support, as a share of the diagonal of the points' box"}, o.maxSupport,
    Range{0.01, 0.5});
  f(Field{"fitWeights", "fit the weights lambda too; lowers the residual by following the noise", "",
          "lambda"},
    o.fitWeights);
  f(Field{"regularisation", "regularisation of the weights lambda", "", "T_reg"}, o.regularisation,
    Range{1e-8, 1.0, true});
}

}  // namespace sonoskin
