#pragma once

#include <span>

namespace sonoskin::ui {

// Licence: under what a part of the program is given to everybody; app/licences.cmake lists them.
//   text  as the part's own authors, or Debian, tell it
struct Licence {
  const char *name, *licence, *text;
};

// licences: Sonoskin's own first, then those of all libraries and fonts that it uses.
std::span<const Licence> licences();

}  // namespace sonoskin::ui
