#include "app/widgets/profile_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/texts/texts.h"
#include "app/widgets/layout.h"
#include "app/widgets/plot_area.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {
namespace {

const std::array<ImVec4, 3> kChannels{kAxial, kCoronal, kSurface};
constexpr int kSteps = ProfileCurves::kSteps;

ImU32 channelColour(int c, float alpha = 1) {
  ImVec4 colour = kChannels[size_t(c)];
  colour.w = alpha;
  return ImGui::GetColorU32(colour);
}

double highest(const std::vector<glm::dvec3>& curve) {
  double most = 0;
  for (const glm::dvec3& v : curve) most = std::max({most, v.x, v.y, v.z});
  return most;
}

// The target wide and pale, the fit thin upon it.
void drawCurves(const ProfilePlot& plot) {
  const ProfileCurves& curves = plot.curves;
  PlotArea area = layOutPlot("profile.curves", 150 * unit(), true);
  area.right = ProfileCurves::kReach;
  area.logarithmic = plot.logarithmic;
  area.high = std::max(1.05 * std::max(highest(curves.target), highest(curves.fit)), 0.1);
  if (plot.logarithmic) area.low = 1e-4;
  drawAxes(area, tr("distance, mm"));
  for (int c = 0; c < 3; ++c) {
    const auto through = [&](const std::vector<glm::dvec3>& curve) {
      return [&, c](int i) { return ImVec2(float(curves.radius[size_t(i)]), float(curve[size_t(i)][c])); };
    };
    if (curves.fitted) drawCurve(area, kSteps, through(curves.target), channelColour(c, 0.4f), 4);
    drawCurve(area, kSteps, through(curves.fit), channelColour(c), 1.4f);
    const double half = radiusOfEnergy(curves.sum, c, 0.5);
    const ImVec2 foot = area.at(half, area.low);
    ImGui::GetWindowDrawList()->AddTriangleFilled({foot.x, foot.y - 6 * unit()},
                                                  {foot.x - 3 * unit(), foot.y},
                                                  {foot.x + 3 * unit(), foot.y}, channelColour(c));
  }
}

void explainCurves(const ProfileCurves& curves) {
  if (!ImGui::IsItemHovered()) return;
  std::string text =
      tr("The share of the light that leaves the skin per millimetre of distance from where it went in, for "
         "red, green and blue; the triangles mark half of it.");
  if (curves.fitted)
    text += std::string("\n") +
            tr("Pale: what the Gaussians are fitted to. Thin: their sum, which the picture uses.");
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(320 * unit());
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void drawError(const ProfileCurves& curves) {
  double most = 1e-6;
  for (size_t i = 0; i < size_t(kSteps); ++i)
    for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(curves.fit[i][c] - curves.target[i][c]));
  most = tickStep(most, 1);
  ImGui::TextDisabled("%s", tr("Error of the fit, 1/mm"));
  PlotArea area = layOutPlot("profile.error", 60 * unit(), false);
  area.right = ProfileCurves::kReach;
  area.low = -most, area.high = most;
  drawAxes(area, "");
  for (int c = 0; c < 3; ++c) {
    const auto difference = [&](int i) {
      return ImVec2(float(curves.radius[size_t(i)]),
                    float(curves.fit[size_t(i)][c] - curves.target[size_t(i)][c]));
    };
    drawCurve(area, kSteps, difference, channelColour(c), 1.2f);
  }
  fact(tr("Off by"), fmt::format("{:.2g}, {:.2g}, {:.2g} % (L2)", 100 * curves.error.x, 100 * curves.error.y,
                                 100 * curves.error.z));
}

void cells(const std::string& label, const std::array<std::string, 3>& values) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(label.c_str());
  for (int c = 0; c < 3; ++c) {
    ImGui::TableNextColumn();
    ImGui::TextColored(kChannels[size_t(c)], "%s", values[size_t(c)].c_str());
  }
}

void drawRadii(const GaussianSum& sum) {
  if (!ImGui::BeginTable("profile radii", 4, ImGuiTableFlags_SizingStretchSame)) return;
  for (double share : {0.5, 0.9}) {
    std::array<std::string, 3> radii;
    for (int c = 0; c < 3; ++c) radii[size_t(c)] = millimetres(radiusOfEnergy(sum, c, share)) + " mm";
    cells(trf("{:.0f} % within", 100 * share), radii);
  }
  ImGui::EndTable();
  noteWidget("profile.radii");
}

void drawWeights(const GaussianSum& sum) {
  if (!ImGui::BeginTable("profile weights", 4, ImGuiTableFlags_SizingStretchSame)) return;
  cells(tr("width, mm"), {tr("red"), tr("green"), tr("blue")});
  for (size_t i = 0; i < sum.variances.size(); ++i) {
    const glm::dvec3& w = sum.weights[i];
    if (w == glm::dvec3(0)) continue;
    cells(fmt::format("{:.3f}", std::sqrt(sum.variances[i])),
          {fmt::format("{:.3f}", w.x), fmt::format("{:.3f}", w.y), fmt::format("{:.3f}", w.z)});
  }
  ImGui::EndTable();
  noteWidget("profile.weights");
}

// The options that the curves depend on; the others as they are by default.
SkinOptions spreadOptions(const SkinOptions& options) {
  SkinOptions spread;
  spread.profile = options.profile;
  spread.width = options.width;
  spread.absorption = options.absorption;
  spread.scattering = options.scattering;
  spread.gaussians = options.gaussians;
  return spread;
}

}  // namespace

void drawProfilePlot(ProfilePlot& plot, const SkinOptions& options) {
  if (const SkinOptions spread = spreadOptions(options); plot.of != spread) {
    plot.of = spread;
    plot.curves = makeProfileCurves(spread);
  }
  ImGui::TextDisabled("%s", tr("Light that leaves at a distance, 1/mm"));
  drawCurves(plot);
  explainCurves(plot.curves);
  ImGui::Checkbox(tr("logarithmic"), &plot.logarithmic);
  noteWidget("profile.logarithmic");
  if (plot.curves.fitted) drawError(plot.curves);
  drawRadii(plot.curves.sum);
  drawWeights(plot.curves.sum);
}

}  // namespace sonoskin::ui
