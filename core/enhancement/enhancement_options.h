#pragma once

#include <array>

#include "core/base/fields.h"

namespace sonoskin {

// EnhancementMethod: what is done to the volume before anything else; diffusion.h has the equation.
enum class EnhancementMethod { none, diffusion };
constexpr auto enumNames(EnhancementMethod) { return std::array{"none", "diffusion"}; }

// EnhancementOptions: speckle reduction before the classification.
struct EnhancementOptions {
  EnhancementMethod method = EnhancementMethod::none;
  int iterations = 3;
  double conductance = 2;
};

template <class F, class O>
requires OptionsOf<O, EnhancementOptions>
void fields(F&& f, O& o) {
  f(Field{"method", "none, or diffusion: smooths speckle and stops at edges"}, o.method);
  f(Field{"iterations", "steps of the diffusion; more smooth farther", "", "n"}, o.iterations, Range{1, 50});
  f(Field{"conductance",
          "gradient at which smoothing falls to half, as a multiple of the volume's typical one", "",
          "kappa"},
    o.conductance, Range{0.1, 20.0, true});
}

}  // namespace sonoskin
