#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace sonoskin {

struct Workspace;

// HelpState: the windows that help, beside the view of the keys, About and the messages.
//   paletteOpens  it has been asked for since the last frame
//   words     that commands are looked for by; chosen: which of those found, counted from the first
//   wantedRow  the parameter whose row is to be brought into sight, "classification.beta"; empty: none
//   keyWords  the same in the window of mouse and keys
//   licence   the one that About shows
//   tour      the card of the tour that is shown
//   offered   the tour is offered, at the first start
struct HelpState {
  bool paletteShown = false, paletteOpens = false;
  std::string words;
  std::size_t chosen = 0;
  std::string wantedRow;
  std::string keyWords;
  std::size_t licence = 0;
  std::optional<std::size_t> tour;
  bool offered = false;
};

// canOpenPalette: not while a question waits for its answer.
bool canOpenPalette(const Workspace& workspace);
void openPalette(Workspace& workspace);

// hasHelpWindow: whether one is open, the messages among them. closeHelpWindow: the one that is most in the way.
bool hasHelpWindow(const Workspace& workspace);
void closeHelpWindow(Workspace& workspace);

}  // namespace sonoskin
