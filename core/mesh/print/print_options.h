#pragma once

#include <array>

#include "core/base/fields.h"

namespace sonoskin {

// PrintForm: how the open surface becomes a solid that can be printed.
//   none    not at all
//   shell   a wall of even thickness behind the surface
//   block   closed at the back by a plane that turns away from the probe: a relief
enum class PrintForm { none, shell, block };
constexpr std::array<const char*, 3> enumNames(PrintForm) { return {"none", "shell", "block"}; }

// PrintOptions: from the mesh to a solid.
struct PrintOptions {
  PrintForm form = PrintForm::none;
  double thickness = 3;
  double scale = 1;
};

template <class F, class O>
requires OptionsOf<O, PrintOptions>
void fields(F&& f, O& o) {
  f(Field{"form", "shell: a wall behind the surface; block: a relief with a flat back"}, o.form);
  f(Field{"thickness", "shell: of the wall; block: of its thinnest place", "mm"}, o.thickness,
    Range{0.4, 50.0});
  f(Field{"scale", "size of the print; 1 is life-size"}, o.scale, Range{0.1, 10.0, true});
}

}  // namespace sonoskin
