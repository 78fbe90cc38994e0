#pragma once

#include <imgui.h>

namespace sonoskin::ui {

// Colours of the interface, sRGB. The three slices have the colours of 3D Slicer.
inline const ImVec4 kAccent{0.29f, 0.67f, 0.75f, 1};
inline const ImVec4 kText{0.87f, 0.89f, 0.91f, 1};
inline const ImVec4 kFaintText{0.56f, 0.60f, 0.65f, 1};
inline const ImVec4 kWarning{0.93f, 0.72f, 0.35f, 1};
inline const ImVec4 kFailure{0.93f, 0.45f, 0.42f, 1};
inline const ImVec4 kAxial{0.90f, 0.36f, 0.32f, 1};
inline const ImVec4 kSagittal{0.91f, 0.78f, 0.30f, 1};
inline const ImVec4 kCoronal{0.42f, 0.75f, 0.41f, 1};
inline const ImVec4 kSurface{0.45f, 0.62f, 0.90f, 1};

// loadFonts: fills ImGui's font atlas for a content scale: Inter, with DejaVu Sans for what it lacks; where
// neither is installed, ImGui's built-in font. Font 0 is the text, then see the functions below.
void loadFonts(float contentScale);
ImFont* headingFont();
ImFont* smallFont();

// applyTheme: colours and sizes of all widgets for a content scale.
void applyTheme(float contentScale);

// unit: the height of a text line without scale is 15; lengths of the layout are given in such pixels times
// this.
float unit();

}  // namespace sonoskin::ui
