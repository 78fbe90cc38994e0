#pragma once

#include <imgui.h>

#include <functional>
#include <glm/glm.hpp>
#include <string>

#include "render/gl/framebuffer.h"

namespace sonoskin::ui {

// PaneInput: what the mouse does in one view in this frame. Positions and lengths in pixels of the screen.
struct PaneInput {
  glm::vec2 corner{0}, size{0};  // of the view
  glm::vec2 mouse{0};            // from the view's upper left corner
  glm::vec2 moved{0};            // since the last frame
  float wheel = 0;               // notches away from the person
  bool hovered = false, doubleClicked = false;
  // the button that was pressed inside the view and is still down; -1 for none
  int button = -1;
  bool pressed = false;  // it went down in this frame
  bool control = false, shift = false;
};

// holdsLeft: whether the left button went down in the view and is down. withoutButton: the same for those who are not to
// see a button.
inline bool holdsLeft(const PaneInput& pane) { return pane.button == ImGuiMouseButton_Left; }
inline PaneInput withoutButton(PaneInput pane) {
  pane.button = -1;
  return pane;
}

// beginPane: takes an area of the screen, notes what the mouse does there, and clips what is drawn to it.
PaneInput beginPane(const char* id, ImVec2 corner, ImVec2 size);
void endPane();

// failureOf: what went wrong while a picture was drawn; empty if nothing did. The other views and all that is around them
// stay.
std::string failureOf(const std::function<void()>& draw);

// showTexture: fills the pane with what a framebuffer holds.
void showTexture(const PaneInput& pane, const gl::Framebuffer& framebuffer);

// Marks over a picture.
void paneTitle(const PaneInput& pane, const char* title, const ImVec4& colour, const std::string& text);
void paneText(const PaneInput& pane, const std::string& text);  // in the middle
// scaleBar: at the lower right; its length is a round number of mm.
void scaleBar(const PaneInput& pane, double pixelsPerMm);
// shadedText: small text that is legible on any picture.
void shadedText(ImVec2 position, const ImVec4& colour, const std::string& text);
// shadedLines: below the title of a view.
void shadedLines(const PaneInput& pane, std::initializer_list<std::string> lines);

}  // namespace sonoskin::ui
