#include "app/widgets/theme.h"

#include <imgui_freetype.h>

#include <array>
#include <cmath>
#include <utility>

#include "app/widgets/font_files.h"

namespace sonoskin::ui {
namespace {

// Heights of a line. The size that is told of Inter elsewhere, its em, is 0.83 of that: 12 and more.
constexpr float kTextSize = 15, kSmallSize = 14.5f;

// Latin, Greek and Cyrillic for file names and symbols; punctuation, arrows, mathematics and shapes for
// labels.
constexpr std::array<ImWchar, 19> kGlyphs{0x0020, 0x024F, 0x0370, 0x03FF, 0x0400, 0x04FF, 0x1E00,
                                          0x1EFF, 0x2010, 0x205E, 0x2070, 0x209F, 0x2190, 0x21FF,
                                          0x2200, 0x22FF, 0x25A0, 0x25FF, 0};

void addFont(FontStyle style, float pixels) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  const FontFiles files = findFontFiles(style);
  if (files.text.empty()) {
    ImFontConfig config;
    config.SizePixels = std::floor(pixels);
    atlas.AddFontDefault(&config);
    return;
  }
  ImFontConfig config;
  config.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  atlas.AddFontFromFileTTF(files.text.c_str(), pixels, &config, kGlyphs.data());
  if (files.fallback.empty()) return;
  config.MergeMode = true;
  atlas.AddFontFromFileTTF(files.fallback.c_str(), pixels, &config, kGlyphs.data());
}

Appearance used = Appearance::dark;

const Colours kDark{{0.099f, 0.104f, 0.111f, 1}, {0.87f, 0.89f, 0.91f, 1}, {0.60f, 0.64f, 0.69f, 1},
                    {0.29f, 0.67f, 0.75f, 1},    {0.36f, 0.72f, 0.60f, 1}, {0.93f, 0.72f, 0.35f, 1},
                    {0.93f, 0.45f, 0.42f, 1}};
const Colours kLight{{0.945f, 0.950f, 0.955f, 1}, {0.10f, 0.12f, 0.14f, 1}, {0.36f, 0.39f, 0.43f, 1},
                     {0.02f, 0.42f, 0.52f, 1},    {0.00f, 0.42f, 0.33f, 1}, {0.55f, 0.33f, 0.00f, 1},
                     {0.72f, 0.13f, 0.10f, 1}};

// Greys between the ground (0) and a part of the way to the text, a little bluish as both are.
ImVec4 toward(const Colours& c, float share, float alpha = 1) {
  return {c.ground.x + share * (c.text.x - c.ground.x), c.ground.y + share * (c.text.y - c.ground.y),
          c.ground.z + share * (c.text.z - c.ground.z), alpha};
}

void applyColours(const Colours& of, ImVec4* c) {
  const auto grey = [&](float share, float alpha = 1) { return toward(of, share, alpha); };
  c[ImGuiCol_Text] = of.text;
  c[ImGuiCol_TextDisabled] = of.faintText;
  c[ImGuiCol_WindowBg] = of.ground;
  c[ImGuiCol_ChildBg] = grey(0, 0);
  c[ImGuiCol_PopupBg] = grey(0.035f, 0.98f);
  c[ImGuiCol_Border] = grey(0.16f);
  c[ImGuiCol_FrameBg] = grey(0.085f);
  c[ImGuiCol_FrameBgHovered] = grey(0.135f);
  c[ImGuiCol_FrameBgActive] = grey(0.16f);
  c[ImGuiCol_MenuBarBg] = grey(0.03f);
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = grey(0.03f);
  c[ImGuiCol_ScrollbarBg] = grey(0, 0);
  c[ImGuiCol_ScrollbarGrab] = grey(0.2f);
  c[ImGuiCol_ScrollbarGrabHovered] = grey(0.29f);
  c[ImGuiCol_ScrollbarGrabActive] = grey(0.37f);
  c[ImGuiCol_CheckMark] = of.accent;
  c[ImGuiCol_SliderGrab] = withAlpha(of.accent, 0.85f);
  c[ImGuiCol_SliderGrabActive] = of.accent;
  c[ImGuiCol_Button] = grey(0.13f);
  c[ImGuiCol_ButtonHovered] = grey(0.2f);
  c[ImGuiCol_ButtonActive] = grey(0.09f);
  c[ImGuiCol_Header] = grey(0.085f);
  c[ImGuiCol_HeaderHovered] = grey(0.14f);
  c[ImGuiCol_HeaderActive] = grey(0.18f);
  c[ImGuiCol_Separator] = grey(0.13f);
  c[ImGuiCol_PlotHistogram] = withAlpha(of.accent, 0.5f);
  c[ImGuiCol_TextSelectedBg] = withAlpha(of.accent, 0.35f);
  c[ImGuiCol_NavHighlight] = of.accent;
  c[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, 0.45f);
  c[ImGuiCol_TableHeaderBg] = grey(0.06f);
  c[ImGuiCol_TableBorderLight] = grey(0.09f);
  c[ImGuiCol_TableBorderStrong] = grey(0.13f);
}

}  // namespace

const Colours& colours() { return coloursOf(used); }

const Colours& coloursOf(Appearance appearance) { return appearance == Appearance::light ? kLight : kDark; }

InAppearance::InAppearance(Appearance appearance) : before_(std::exchange(used, appearance)) {}
InAppearance::~InAppearance() { used = before_; }

ImVec4 withAlpha(const ImVec4& colour, float alpha) { return {colour.x, colour.y, colour.z, alpha}; }

void loadFonts(float contentScale) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  addFont(FontStyle::regular, kTextSize * contentScale);
  addFont(FontStyle::semibold, kTextSize * contentScale);
  addFont(FontStyle::regular, kSmallSize * contentScale);
}

ImFont* headingFont() { return ImGui::GetIO().Fonts->Fonts[1]; }
ImFont* smallFont() { return ImGui::GetIO().Fonts->Fonts[2]; }

void applyTheme(float contentScale, Appearance appearance) {
  used = appearance;
  ImGuiStyle style;
  applyColours(colours(), style.Colors);
  style.WindowPadding = {12, 10};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {6, 4};
  style.CellPadding = {4, 3};
  style.IndentSpacing = 14;
  style.ScrollbarSize = 11;
  style.GrabMinSize = 9;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
  style.WindowRounding = 0;
  style.PopupRounding = 6;
  style.FrameRounding = 4;
  style.GrabRounding = 3;
  style.ScrollbarRounding = 6;
  style.WindowTitleAlign = {0, 0.5f};
  style.ScaleAllSizes(contentScale);
  ImGui::GetStyle() = style;
}

float unit() { return ImGui::GetIO().Fonts->Fonts[0]->FontSize / kTextSize; }

}  // namespace sonoskin::ui
