#pragma once

#include <imgui.h>

#include <initializer_list>
#include <string>

#include "app/widgets/number_text.h"

namespace sonoskin::ui {

// Small pieces that the panels share.

// section: the heading of a part of the side panel.
void section(const char* title);

// heading: of rows that belong together, below a section.
void heading(const char* title);

// sentenceText: a faint sentence that is wrapped.
void sentenceText(const char* text);

// fact: a line "label   value"; a `warning` value is coloured.
void fact(const char* label, const std::string& value, bool warning = false);

// segments: a row of buttons of which one is down; true when another was pressed.
bool segments(const char* id, std::initializer_list<const char*> names, int& chosen);

// textSegments: the same with buttons as wide as their texts; textSegmentsWidth: of all of them.
bool textSegments(const char* id, std::initializer_list<const char*> names, int& chosen);
float textSegmentsWidth(std::initializer_list<const char*> names);

// switchButton: a button in the accent's colour while it is on.
//   width  0: as wide as its text
bool switchButton(const char* title, bool on, float width = 0);

// foldout: a heading, in English as its tooltip, that opens and closes what follows; true while it is open.
bool foldout(const char* title, const char* tooltip);

// mainButton: a button over the whole width, in the accent's colour.
bool mainButton(const char* title, bool enabled);

// disabledIf: greys and blocks what is drawn while it lives.
class DisabledIf {
 public:
  explicit DisabledIf(bool disabled) { ImGui::BeginDisabled(disabled); }
  ~DisabledIf() { ImGui::EndDisabled(); }
  DisabledIf(const DisabledIf&) = delete;
  DisabledIf& operator=(const DisabledIf&) = delete;
};

}  // namespace sonoskin::ui
