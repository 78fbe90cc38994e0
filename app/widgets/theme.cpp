#include "app/widgets/theme.h"

#include <imgui_freetype.h>

#include <array>
#include <cmath>

#include "app/widgets/font_files.h"

namespace sonoskin::ui {
namespace {

constexpr float kTextSize = 15, kSmallSize = 12.5f;

// Latin, Greek and Cyrillic for file names and symbols; punctuation, arrows, mathematics and shapes for
// labels.
constexpr std::array<ImWchar, 17> kGlyphs{0x0020, 0x024F, 0x0370, 0x03FF, 0x0400, 0x04FF,
                                          0x2010, 0x205E, 0x2070, 0x209F, 0x2190, 0x21FF,
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

ImVec4 grey(float value, float alpha = 1) { return {value * 0.94f, value * 0.99f, value * 1.06f, alpha}; }
ImVec4 accent(float alpha) { return {kAccent.x, kAccent.y, kAccent.z, alpha}; }

void applyColours(ImVec4* c) {
  c[ImGuiCol_Text] = kText;
  c[ImGuiCol_TextDisabled] = kFaintText;
  c[ImGuiCol_WindowBg] = grey(0.105f);
  c[ImGuiCol_ChildBg] = grey(0.105f, 0);
  c[ImGuiCol_PopupBg] = grey(0.135f, 0.98f);
  c[ImGuiCol_Border] = grey(0.22f);
  c[ImGuiCol_FrameBg] = grey(0.165f);
  c[ImGuiCol_FrameBgHovered] = grey(0.205f);
  c[ImGuiCol_FrameBgActive] = grey(0.225f);
  c[ImGuiCol_MenuBarBg] = grey(0.125f);
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = grey(0.125f);
  c[ImGuiCol_ScrollbarBg] = grey(0.1f, 0);
  c[ImGuiCol_ScrollbarGrab] = grey(0.25f);
  c[ImGuiCol_ScrollbarGrabHovered] = grey(0.32f);
  c[ImGuiCol_ScrollbarGrabActive] = grey(0.38f);
  c[ImGuiCol_CheckMark] = kAccent;
  c[ImGuiCol_SliderGrab] = accent(0.85f);
  c[ImGuiCol_SliderGrabActive] = kAccent;
  c[ImGuiCol_Button] = grey(0.20f);
  c[ImGuiCol_ButtonHovered] = grey(0.26f);
  c[ImGuiCol_ButtonActive] = grey(0.17f);
  c[ImGuiCol_Header] = grey(0.165f);
  c[ImGuiCol_HeaderHovered] = grey(0.21f);
  c[ImGuiCol_HeaderActive] = grey(0.24f);
  c[ImGuiCol_Separator] = grey(0.2f);
  c[ImGuiCol_PlotHistogram] = accent(0.5f);
  c[ImGuiCol_TextSelectedBg] = accent(0.35f);
  c[ImGuiCol_NavHighlight] = accent(0.8f);
  c[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, 0.45f);
  c[ImGuiCol_TableHeaderBg] = grey(0.15f);
  c[ImGuiCol_TableBorderLight] = grey(0.17f);
  c[ImGuiCol_TableBorderStrong] = grey(0.2f);
}

}  // namespace

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

void applyTheme(float contentScale) {
  ImGuiStyle style;
  applyColours(style.Colors);
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
