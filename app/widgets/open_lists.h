#pragma once

namespace sonoskin::ui {

// Menus, lists of choices and small windows that close when something else is clicked: not the questions that must be answered.

// listIsOpen: whether one of them is. closeList: the last one that was opened.
bool listIsOpen();
void closeList();

// openMenu: the menu of that title, with the keyboard on its first entry; inside the menu bar.
void openMenu(const char* title);

// steerLists: just before ImGui's frame, when it knows the keys: while one is open, arrows, Enter and the space bar steer it.
void steerLists();

}  // namespace sonoskin::ui
