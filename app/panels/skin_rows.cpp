#include "app/panels/skin_rows.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>

#include "app/document/landmarks.h"
#include "app/panels/parameter_rows.h"
#include "app/panels/preset_row.h"
#include "app/texts/texts.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/skin_looks.h"

namespace sonoskin::ui {
namespace {

constexpr std::array<const char*, 19> kPassTitles{"Skin",
                                                  "No light below the surface",
                                                  "Light that arrives",
                                                  "Light, spread once",
                                                  "Light, spread twice",
                                                  "Light, spread three times",
                                                  "Light, spread four times",
                                                  "Light, spread five times",
                                                  "Light below the surface",
                                                  "Light through thin parts",
                                                  "Reflection",
                                                  "Colour",
                                                  "Roughness, gloss, water",
                                                  "Shadows",
                                                  "Openness to light",
                                                  "Normals",
                                                  "Curvature",
                                                  "Stretch of the map",
                                                  "Parts of the map"};
static_assert(kPassTitles.size() == enumNames(SkinPass{}).size());

void wrappedTooltip(const char* text) {
  if (!ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 22);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

FieldsEdit landmarkRow(std::size_t index, LandmarkOptions& landmarks, ViewState& view) {
  const NamedLandmark& landmark = kLandmarks[index];
  std::array<double, 3>& place = landmarks.*landmark.place;
  const float clear =
      std::max(52 * unit(), ImGui::CalcTextSize(tr("Clear")).x + 2 * ImGui::GetStyle().FramePadding.x);
  const bool placing = isChosen(view, Tool::landmark) && view.landmark == index;
  beginRow(tr(landmark.name));
  ImGui::PushID(landmark.name);
  const float width = ImGui::GetContentRegionAvail().x - clear - ImGui::GetStyle().ItemSpacing.x;
  if (switchButton(tr(placing ? "Click on it" : isSet(place) ? "Place again" : "Place"), placing, width)) {
    view.spaceTool = placing ? Tool::crossHair : Tool::landmark;
    view.landmark = index;
  }
  noteWidget(fmt::format("landmark.{}", index));
  wrappedTooltip(tr("Then click on the place in the 3D view. Escape: do not."));
  ImGui::SameLine();
  FieldsEdit edit;
  {
    const DisabledIf unset(!isSet(place));
    if (ImGui::Button(tr("Clear"), {clear, 0})) {
      place = {};
      edit = {true, true};
    }
    noteWidget(fmt::format("landmark.{}.clear", index));
  }
  ImGui::PopID();
  return edit;
}

void passRow(SkinShow& show) {
  beginRow(tr("Show"));
  if (ImGui::BeginCombo("##pass", passTitle(show.pass), ImGuiComboFlags_HeightLargest)) {
    for (std::size_t i = 0; i < kPassTitles.size(); ++i) {
      if (ImGui::Selectable(tr(kPassTitles[i]), show.pass == SkinPass(i))) show.pass = SkinPass(i);
      noteWidget(std::string("skin.pass.") + enumNames(SkinPass{})[i]);
    }
    ImGui::EndCombo();
    return;
  }
  noteWidget("skin.pass");
}

void keep(SkinShow& show, const Parameters& p) { show.kept = {p.skin, p.light, p.landmarks}; }

void compareRows(SkinShow& show, const Parameters& p) {
  beginRow(tr("Compare"));
  int compare = int(show.compare);
  if (segments("skin.compare", {"Off", "Scatter", "A | B"}, compare)) {
    show.compare = SkinCompare(compare);
    if (show.compare == SkinCompare::settings && !show.kept) keep(show, p);
  }
  beginRow("");
  const DisabledIf alone(show.compare != SkinCompare::settings);
  if (ImGui::Button(tr("Keep this as A"), {-1, 0})) keep(show, p);
  noteWidget("skin.keep");
  wrappedTooltip(tr("The left half shows what is kept, the right half what the sliders say."));
}

// What is drawn, and why.
std::string qualityText(const SkinStatus& status) {
  const std::string quality = tr(status.full ? "full quality" : "light quality");
  if (status.milliseconds <= 0) return quality;
  return trf("{}, {:.0f} ms a picture", quality, status.milliseconds);
}

void qualityRows(Workspace& w) {
  beginRow(tr("Quality"));
  int choice = int(w.settings.skinQuality);
  if (segments("skin.quality", {"Auto", "Full", "Light"}, choice))
    w.settings.skinQuality = SkinQualityChoice(choice);
  beginRow("");
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", qualityText(w.view.skin.status).c_str());
  wrappedTooltip(
      tr("Full: every triangle and texels of 0.15 mm. Light: 100,000 triangles and texels of 0.3 mm, for "
         "machines "
         "without a graphics card. Auto takes full where a picture is drawn in less than 30 ms."));
}

}  // namespace

const char* passTitle(SkinPass pass) { return tr(kPassTitles[std::size_t(pass)]); }

FieldsEdit lookRow(Parameters& parameters) {
  beginRow(tr("Look"));
  const Look look = lookOf(parameters);
  const std::string title =
      !look.preset ? tr("Your own")
                   : presetTitle(look.preset->name) + (look.otherLight ? tr(", other light") : "");
  FieldsEdit edit;
  if (ImGui::BeginCombo("##look", title.c_str(), ImGuiComboFlags_HeightLargest)) {
    for (const SkinPreset& preset : skinPresets()) {
      const bool chosen = look.preset == &preset && !look.otherLight;
      if (ImGui::Selectable(presetTitle(preset.name).c_str(), chosen) && !chosen) {
        applySkinPreset(preset, parameters.skin, parameters.light);
        edit = {true, true};
      }
      noteWidget("look." + std::string(preset.name));
      wrappedTooltip((sentence(tr(preset.help)) + ".").c_str());
    }
    ImGui::EndCombo();
    return edit;
  }
  noteWidget("look");
  if (look.preset) wrappedTooltip((sentence(tr(look.preset->help)) + ".").c_str());
  return edit;
}

FieldsEdit landmarkRows(Parameters& parameters, ViewState& view) {
  FieldsEdit edit;
  view.skin.places = foldout("Landmarks", "Places of the face, for the colour of lips, lids and cheeks.");
  if (!view.skin.places) return edit;
  if (beginFields("landmarks")) {
    for (std::size_t i = 0; i < kLandmarks.size(); ++i) edit |= landmarkRow(i, parameters.landmarks, view);
    endFields();
  }
  return edit;
}

void drawSkinShow(Workspace& workspace) {
  heading(tr("View"));
  if (!beginFields("skin show")) return;
  passRow(workspace.view.skin);
  compareRows(workspace.view.skin, workspace.session.parameters());
  qualityRows(workspace);
  endFields();
}

}  // namespace sonoskin::ui
