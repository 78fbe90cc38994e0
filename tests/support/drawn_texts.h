#pragma once

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace sonoskin::ui {

// DrawnLetter: one letter of the frame that Dear ImGui has drawn last, cut to what its window shows of it.
//   text  the number of its text in the window
//   cut   a part of it is missing at its left or right
struct DrawnLetter {
  unsigned letter;
  ImRect place;
  std::size_t text;
  bool cut;
};

// GlyphPlaces: the letters of all fonts, by the corners of their places in the fonts' texture.
struct GlyphPlaces {
  using Corner = std::array<float, 2>;
  std::map<Corner, const ImFontGlyph*> byFirst, byLast;

  GlyphPlaces() {
    for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
      for (const ImFontGlyph& glyph : font->Glyphs) {
        byFirst[{glyph.U0, glyph.V0}] = &glyph;
        byLast[{glyph.U1, glyph.V1}] = &glyph;
      }
  }
  // A letter that is not whole has one of its corners; null for a plain shape.
  const ImFontGlyph* of(const ImVec2& first, const ImVec2& last) const {
    if (first.x == last.x || first.y == last.y) return nullptr;
    if (const auto found = byFirst.find({first.x, first.y}); found != byFirst.end()) return found->second;
    const auto found = byLast.find({last.x, last.y});
    return found == byLast.end() ? nullptr : found->second;
  }
};

// DrawnTexts: of one window: its texts, and their letters.
struct DrawnTexts {
  const GlyphPlaces& glyphs;
  std::vector<DrawnLetter> letters = {};
  std::vector<std::string> texts = {};
  std::optional<ImRect> before = {};

  void read(const ImDrawList& list, const ImDrawCmd& command) {
    for (unsigned i = 0; i + 5 < command.ElemCount;) {
      const auto at = [&](unsigned n) -> const ImDrawVert& {
        return list.VtxBuffer[int(command.VtxOffset) + list.IdxBuffer[int(command.IdxOffset + i + n)]];
      };
      const ImFontGlyph* glyph = glyphs.of(at(0).uv, at(2).uv);
      if (glyph) take(*glyph, at(0), at(2), ImRect(command.ClipRect));
      i += glyph ? 6 : 3;
    }
  }

 private:
  // Whether a letter goes on where the one before ended.
  static bool follows(const ImRect& last, const ImRect& now) {
    const float height = last.GetHeight() + now.GetHeight();
    return now.Min.x > last.Min.x - 1 && now.Min.x - last.Max.x < height && now.Min.y < last.Max.y + height &&
           now.Max.y > last.Min.y - height;
  }
  void take(const ImFontGlyph& glyph, const ImDrawVert& first, const ImDrawVert& last, const ImRect& window) {
    ImRect place(first.pos, last.pos);
    if (!before || !follows(*before, place)) texts.emplace_back();
    before = place;
    char utf8[5] = {};
    texts.back() += ImTextCharToUtf8(utf8, glyph.Codepoint);
    if (place.Max.y <= window.Min.y || place.Min.y >= window.Max.y) return;  // scrolled away
    constexpr float kEdge = 1;  // of a pixel that the smoothing of letters may take
    const bool beyond = place.Min.x < window.Min.x - kEdge || place.Max.x > window.Max.x + kEdge;
    const bool part = first.uv.x != glyph.U0 || last.uv.x != glyph.U1;
    place.ClipWith(window);
    letters.push_back({glyph.Codepoint, place, texts.size() - 1, beyond || part});
  }
};

// A text that is a part of another, and lies there, is its shade.
inline bool isShade(const std::string& a, const std::string& b) {
  return a.find(b) != a.npos || b.find(a) != b.npos;
}

inline bool areOver(const DrawnLetter& a, const DrawnLetter& b) {
  ImRect both = a.place;
  both.ClipWith(b.place);
  const float least = std::min(a.place.GetArea(), b.place.GetArea());
  return a.text != b.text && both.GetWidth() > 0 && both.GetHeight() > 0 && both.GetArea() > 0.2f * least;
}

// textFaults: what is wrong with the texts of the frame that was drawn last, a line each: a text of which a part is cut off at the
// edge of its place, and texts that lie over one another within one window. Texts that scroll away upward and downward are right.
// Needs a frame that ended with ImGui::Render(), and fonts whose texture is made.
inline std::set<std::string> textFaults() {
  const GlyphPlaces glyphs;
  std::set<std::string> faults;
  const ImDrawData& data = *ImGui::GetDrawData();
  for (int n = 0; n < data.CmdListsCount; ++n) {
    DrawnTexts window{glyphs};
    for (const ImDrawCmd& command : data.CmdLists[n]->CmdBuffer)
      if (command.TextureId == ImGui::GetIO().Fonts->TexID) window.read(*data.CmdLists[n], command);
    for (auto a = window.letters.begin(); a != window.letters.end(); ++a) {
      if (a->cut) faults.insert("cut off: \"" + window.texts[a->text] + "\"");
      for (auto b = a + 1; b != window.letters.end(); ++b)
        if (areOver(*a, *b) && !isShade(window.texts[a->text], window.texts[b->text]))
          faults.insert("\"" + window.texts[a->text] + "\" lies over \"" + window.texts[b->text] + "\"");
    }
  }
  return faults;
}

}  // namespace sonoskin::ui
