#include "app/widgets/field_equations.h"

#include <algorithm>
#include <array>

#include "app/texts/texts.h"

namespace sonoskin::ui {
namespace {

// Equation: with what a person should read in it, which may be empty.
struct Equation {
  std::string_view id, text;
  const char* words = "";
};

// [theory/classification.md, 3.1 to 3.4; theory/reconstruction.md, 2.2 to 2.8]
constexpr std::array kEquations{
    Equation{"classification.alpha", "E(u) = ½ ∑ α a u² + β′ |∇u × g|² + γ h (u − u_ind)²",
             "α: u goes to 0 where a, the distance to v_iso, is large"},
    Equation{"classification.beta", "E(u) = ½ ∑ α a u² + β′ |∇u × g|² + γ h (u − u_ind)²",
             "β′ = β l² γ h_ref: no change of u along the surface"},
    Equation{"classification.gamma", "E(u) = ½ ∑ α a u² + β′ |∇u × g|² + γ h (u − u_ind)²",
             "γ: u goes to u_ind where h, the edge, is strong"},
    Equation{"classification.isoValue", "a = (w (v − v_iso)² + (1 − w) (ṽ − v_iso)² + nf²) / |∇ṽ|²",
             "the squared distance, in voxels, to the iso-surface"},
    Equation{"classification.isoShare", "v_iso = v_fluid + s (v_edge − v_fluid)"},
    Equation{"classification.rawShare", "a = (w (v − v_iso)² + (1 − w) (ṽ − v_iso)² + nf²) / |∇ṽ|²"},
    Equation{"classification.noiseFloor", "a = (w (v − v_iso)² + (1 − w) (ṽ − v_iso)² + nf²) / |∇ṽ|²"},
    Equation{"classification.farthest", "a ≤ a_max"},
    Equation{"classification.gradientFloor", "h = δ + (1 − δ) min(1, |∇ṽ| / g_ref)"},
    Equation{"classification.gradientReference", "h = δ + (1 − δ) min(1, |∇ṽ| / g_ref)"},
    Equation{"classification.target", "E(u) = ½ ∑ … + γ h (u − u_ind)²"},
    Equation{"classification.lowPass", "ṽ = G_σ ∗ v"},
    Equation{"classification.tangentialLength", "β′ = β l² γ h_ref"},
    Equation{"classification.directionScale", "g = ∇ṽ / √(|∇ṽ|² + κ²)"},
    Equation{"reconstruction.smoothness", "E_SA(σ) = E_local² + (T_sa L / σ)²",
             "its least σ is the support of a centre"}};

}  // namespace

std::string equationOf(std::string_view id) {
  const auto found = std::ranges::find(kEquations, id, &Equation::id);
  if (found == kEquations.end()) return {};
  return std::string(found->text) + (*found->words ? std::string("\n") + tr(found->words) : "");
}

}  // namespace sonoskin::ui
