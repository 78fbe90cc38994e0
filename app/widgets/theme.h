#pragma once

#include <imgui.h>

#include "app/widgets/appearance.h"

namespace sonoskin::ui {

// Marks over the pictures of the views, sRGB; the views are dark in every appearance. The three slices have the red, yellow
// and green of 3D Slicer in tones that the colour-blind tell apart [Okabe and Ito 2008]; all carry a letter or a name besides.
inline const ImVec4 kAccent{0.29f, 0.67f, 0.75f, 1};
inline const ImVec4 kText{0.87f, 0.89f, 0.91f, 1};
inline const ImVec4 kFaintText{0.62f, 0.66f, 0.71f, 1};
inline const ImVec4 kWarning{0.93f, 0.72f, 0.35f, 1};
inline const ImVec4 kFailure{0.93f, 0.45f, 0.42f, 1};
inline const ImVec4 kAxial{0.88f, 0.35f, 0.20f, 1};
inline const ImVec4 kSagittal{0.94f, 0.87f, 0.36f, 1};
inline const ImVec4 kCoronal{0.12f, 0.68f, 0.53f, 1};
inline const ImVec4 kOblique{0.75f, 0.56f, 0.95f, 1};
inline const ImVec4 kSurface{0.45f, 0.62f, 0.90f, 1};

// Colours: of panels, menus and windows in the appearance in use, sRGB.
//   ground  what they lie on
//   good    a result that is there; warning, failure: what is doubtful, and what went wrong
struct Colours {
  ImVec4 ground, text, faintText, accent, good, warning, failure;
};
const Colours& colours();
const Colours& coloursOf(Appearance appearance);
// InAppearance: while it lives, colours() are those of that appearance: over pictures, which are dark in either.
class InAppearance {
 public:
  explicit InAppearance(Appearance appearance);
  ~InAppearance();
  InAppearance(const InAppearance&) = delete;
  InAppearance& operator=(const InAppearance&) = delete;

 private:
  Appearance before_;
};
// withAlpha: the same colour, so opaque.
ImVec4 withAlpha(const ImVec4& colour, float alpha);

// loadFonts: fills ImGui's font atlas for a content scale: Inter, with DejaVu Sans for what it lacks; where
// neither is installed, ImGui's built-in font. Font 0 is the text, then see the functions below.
void loadFonts(float contentScale);
ImFont* headingFont();
ImFont* smallFont();

// applyTheme: colours and sizes of all widgets for a content scale.
void applyTheme(float contentScale, Appearance appearance = Appearance::dark);

// unit: the height of a text line without scale is 15; lengths of the layout are given in such pixels times
// this.
float unit();

}  // namespace sonoskin::ui
