#include <imgui.h>

#include <array>

#include "app/panels/panels.h"
#include "app/panels/parameter_rows.h"
#include "app/panels/skin_rows.h"
#include "app/texts/texts.h"
#include "app/widgets/layout.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/commands.h"

namespace sonoskin::ui {
namespace {

using Names = std::span<const std::string_view>;

constexpr std::array<std::string_view, 8> kSurface{"colour",   "wetness", "vernix",    "flush",
                                                   "mottling", "gloss",   "roughness", "detail"};
constexpr std::array<std::string_view, 4> kPigments{"melanin", "blood", "oxygen", "epidermis"};
constexpr std::array<std::string_view, 9> kScattering{"profile",    "width",        "mix",
                                                      "absorption", "scattering",   "gaussians",
                                                      "thinModel",  "translucency", "density"};
constexpr std::array<std::string_view, 4> kLight{"kind", "strength", "warmth", "exposure"};

RowText skinText(const Parameters& p, std::string_view field) {
  RowText text = useOf(p, "skin")(field);
  if (field == "detail") text.label = tr("Pores");
  if (field == "width") text.label = tr("Reach");
  if (field == "mix") text.label = tr("Colour before");
  if (field == "thinModel") text.label = tr("Thin parts");
  return text;
}

template <class Options>
FieldsEdit drawRows(const char* id, std::string_view group, Options& options, const Rows& rows) {
  FieldsEdit edit;
  if (!beginFields(id)) return edit;
  edit = editFields(group, options, rows);
  endFields();
  return edit;
}

FieldsEdit drawSkinRows(const char* id, Names names, Parameters& p) {
  return drawRows(id, "skin", p.skin, {names, false, [&](std::string_view f) { return skinText(p, f); }});
}

FieldsEdit drawPigments(Parameters& p) {
  if (!foldout("Pigments", "What the skin's colour is made from.")) return {};
  return drawSkinRows("pigments", kPigments, p);
}

// While it is open, the view shows how far light spreads.
FieldsEdit drawScattering(Parameters& p, SkinShow& show) {
  show.reach = foldout("Scattering", "How light spreads below the surface, and through thin parts.");
  if (!show.reach) return {};
  return drawSkinRows("scattering", kScattering, p);
}

FieldsEdit drawSkin(Parameters& p) {
  FieldsEdit edit;
  if (beginFields("skin")) {
    edit |= lookRow(p);
    edit |= editFields("skin", p.skin, {kSurface, false, [&](std::string_view f) { return skinText(p, f); }});
    endFields();
  }
  return edit;
}

FieldsEdit drawLight(Parameters& p) {
  heading(tr("Lighting"));
  FieldsEdit edit = drawRows("light", "light", p.light, {kLight, false, useOf(p, "light")});
  if (foldout("More light",
              "Where the light is, how soft, and the other lights. The lamp in the view can be dragged."))
    edit |= drawRows("more light", "light", p.light, {kLight, true, useOf(p, "light")});
  return edit;
}

// Whether the 3D view shows what the rows change, and how to make it.
void drawShown(Workspace& workspace) {
  const Command& show = command("view.skin");
  const bool shown = show.checked(workspace);
  const DisabledIf disabled(shown || !isEnabled(show, workspace));
  if (ImGui::Button(tr(shown ? "The 3D view shows skin" : "Show skin in the 3D view"), {-1, 0}))
    show.run(workspace);
  noteWidget("skin.show");
}

}  // namespace

void drawSkinPanel(Workspace& workspace) {
  drawShown(workspace);
  const DisabledIf disabled(!workspace.session.results().mesh);
  Parameters p = workspace.session.parameters();
  FieldsEdit edit = drawSkin(p);
  drawSkinShow(workspace);
  edit |= drawPigments(p);
  SkinShow& show = workspace.view.skin;
  edit |= drawScattering(p, show);
  if (show.reach) drawProfilePanel(workspace);
  edit |= drawLight(p);
  edit |= landmarkRows(p, workspace.view);
  applyEdit(workspace, p, edit);
}

}  // namespace sonoskin::ui
