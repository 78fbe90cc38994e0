#pragma once

namespace sonoskin::ui {

// Menus, lists of choices and small windows that close when something else is clicked: not the questions that must be answered.

// openLists: how many of them, and of questions below them, are open; 0 where none of them lies on top. closeLists: all
// above the last question.
int openLists();
inline bool listIsOpen() { return openLists() > 0; }
void closeLists();

// openMenu: the menu of that title, with the keyboard on its first entry; inside the menu bar.
void openMenu(const char* title);

// leavesMenu: inside the menu bar, behind its menus: 1 or -1 where the keyboard leaves the one that is open for the next or the
// one before, else 0.
int leavesMenu();

// popupIsOpen: whether a list or a question is.
bool popupIsOpen();

// questionIsOpen: whether one lies on top.
bool questionIsOpen();

// leaveField: whatever is being typed is done.
void leaveField();

// mainHasKeys: whether no window that lies over the main one has them.
bool mainHasKeys();

// focusChild: the keyboard goes to the first widget of a child window of that name; whether there is one.
bool focusChild(const char* name);

// KeySteering: whether keys steer the widgets of the window, and the step to the next one, or the one before, in this frame: in the
// window, and in a question.
struct KeySteering {
  bool widgets = false;
  int step = 0, questionStep = 0;
};
// steerByKeys: just before ImGui's frame, when it knows the keys: while a list or a question is open, or `steering` says so,
// arrows, Enter and the space bar steer what is there.
void steerByKeys(const KeySteering& steering);

// stepOn: when a frame's widgets are drawn: the step in a question goes on from the end of a line to the next one.
void stepOn();

}  // namespace sonoskin::ui
