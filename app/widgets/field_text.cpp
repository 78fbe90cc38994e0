#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <cstdio>
#include <map>

#include "app/widgets/fields_ui.h"

#include "app/texts/texts.h"

namespace sonoskin::ui {

namespace {

// What a field is called where its own name says little.
const std::map<std::string_view, const char*> kLabels{
    {"isoValue", "Iso-value"},          {"alpha", "Suppression"},        {"beta", "Smoothing"},
    {"gamma", "Edge strength"},         {"isoShare", "Iso share"},       {"lowPass", "Noise filter"},
    {"gradientReference", "Full edge"}, {"gradientFloor", "Edge floor"}, {"gradientSource", "Edges from"}};

}  // namespace

std::string fieldName(const Field& field) {
  if (const auto label = kLabels.find(field.name); label != kLabels.end()) return label->second;
  std::string label;
  for (const char c : field.name) {
    if (std::isupper(static_cast<unsigned char>(c))) label += ' ';
    label += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return capitalised(label);
}

std::string fieldLabel(const Field& field) { return tr(std::string_view(fieldName(field))); }

std::string presetTitle(std::string_view name) {
  std::string title(name);
  std::replace(title.begin(), title.end(), '-', ' ');
  return tr(std::string_view(capitalised(title)));
}

std::string greekSymbol(std::string_view symbol) {
  static const std::map<std::string_view, const char*> letters{
      {"alpha", "α"},  {"beta", "β"},    {"gamma", "γ"},     {"delta", "δ"},       {"kappa", "κ"},
      {"lambda", "λ"}, {"sigma", "σ"},   {"tau", "τ"},       {"mu", "μ"},          {"theta", "θ"},
      {"rho", "ρ"},    {"rho_s", "ρ_s"}, {"sigma_a", "σ_a"}, {"sigma_s'", "σ′_s"}, {"sqrt(a_max)", "√a_max"}};
  const auto found = letters.find(symbol);
  return found == letters.end() ? std::string(symbol) : found->second;
}

std::string fieldNumber(double value, Range<double> range) {
  if (range.logarithmic) return fmt::format("{:#.3g}", value);
  const double width = range.max - range.min;
  return fmt::format("{:.{}f}", value, width <= 0.5 ? 3 : width <= 20 ? 2 : width <= 2000 ? 1 : 0);
}

double roundedForSlider(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  // By way of text: dividing by a power of ten would leave 0.30000000000000004.
  return std::stod(fmt::format("{:.2e}", value));
}

}  // namespace sonoskin::ui
