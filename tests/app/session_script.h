#pragma once

#include <span>

#include "tests/app/player.h"

namespace sonoskin::test {

// A session as a person has it, from the first file to the same picture again, in pieces. The same for a mouse of the display, for
// slow frames, for events without a window and for a program that is killed in between.

// ScriptPiece: each begins where the one before ended, at rest.
struct ScriptPiece {
  const char* name;
  void (*play)(Player& player);
};

// sessionScript: up to the saved mesh.
std::span<const ScriptPiece> sessionScript();

// beginScript: the scan that it opens, in the player's folder.
void beginScript(Player& player);
// quitAndReopen: the end of it: quits, is asked, saves the session, opens it again: the same picture.
void quitAndReopen(Player& player);

// scriptParameters: a small scan, and a mesh that takes seconds.
Parameters scriptParameters();

}  // namespace sonoskin::test
