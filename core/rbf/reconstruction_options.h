#pragma once

#include <array>

#include "core/base/fields.h"

namespace sonoskin {

// ReconstructionMethod: how the implicit function comes from the points.
//   adaptive   compactly supported radial basis functions (Ohtake, Belyaev, Seidel 2004 and 2006)
//   thesis     the same as the thesis' program has it: its own weights and search, no partition of unity; to compare
//   global     one radial basis function over all points (Carr et al. 2001): GlobalOptions
enum class ReconstructionMethod { adaptive, thesis, global };
constexpr std::array<const char*, 3> enumNames(ReconstructionMethod) {
  return {"adaptive", "thesis", "global"};
}

// ReconstructionOptions: adaptive compactly supported radial basis functions.
struct ReconstructionOptions {
  ReconstructionMethod method = ReconstructionMethod::adaptive;
  double smoothness = 2e-5;
  bool measuredNoise = true;
  double overlap = 1.5;
  int neighbours = 10;
  double maxSupport = 0.07;
  bool confidence = true;
  bool fitWeights = false;
  double regularisation = 1e-4;
};

template <class F, class O>
requires OptionsOf<O, ReconstructionOptions>
void fields(F&& f, O& o) {
  f(Field{"method",
          "adaptive: local and fast; thesis: as the thesis' program did; global: one function through all"},
    o.method);
  f(Field{"smoothness", "1e-5 keeps detail and noise, 1e-4 is smooth", "", "T_sa"}, o.smoothness,
    Range{1e-6, 1e-3, true});
  f(Field{"measuredNoise",
          "each place is as smooth as its measured noise asks for: smoothness then says how much more or "
          "less than "
          "2e-5, which stands for just so much; off: the same smoothness everywhere"},
    o.measuredNoise);
  f(Field{"overlap", "supports that must cover every point, at least", "", "T_overlap"}, o.overlap,
    Range{0.5, 4.0});
  f(Field{"neighbours", "neighbours that measure the density around a point", "", "K"}, o.neighbours,
    Range{3, 50});
  f(Field{"maxSupport", "largest support, as a share of the diagonal of the points' box"}, o.maxSupport,
    Range{0.01, 0.5});
  f(Field{"confidence", "points count by the strength of their echo", "", "c_i"}, o.confidence);
  f(Field{"fitWeights", "fit the weights lambda too; lowers the residual by following the noise", "",
          "lambda"},
    o.fitWeights);
  f(Field{"regularisation", "regularisation of the weights lambda", "", "T_reg"}, o.regularisation,
    Range{1e-8, 1.0, true});
}

}  // namespace sonoskin
