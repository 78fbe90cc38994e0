#pragma once

#include <imgui.h>

#include <initializer_list>
#include <string>

namespace sonoskin::ui {

// Small pieces that the panels share.

// section: the heading of a part of the side panel.
void section(const char* title);

// fact: a line "label   value"; a `warning` value is coloured.
void fact(const char* label, const std::string& value, bool warning = false);

// segments: a row of buttons of which one is down; true when another was pressed. `enabled` false greys it.
bool segments(const char* id, std::initializer_list<const char*> names, int& chosen);

// foldout: a heading that opens and closes what follows; true while it is open.
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

// grouped: 1234567 as "1,234,567".
std::string grouped(std::size_t number);
// millimetres: without needless digits: "0.52", "12.3".
std::string millimetres(double value);

}  // namespace sonoskin::ui
