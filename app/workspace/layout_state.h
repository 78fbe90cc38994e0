#pragma once

#include <array>

#include "render/slice_axes.h"

namespace sonoskin {

// Layout: which views share the window.
//   fourUp   the three planes and 3D
//   compare  one plane's slice raw, classified and thinned, and 3D, for the iso-surface of the classified volume
//   casts    the same ray-cast raw, classified and thinned, and 3D, with one camera for all
//   oblique  a slice that can be turned, and 3D, above the three planes
enum class Layout { fourUp, compare, casts, oblique };
constexpr std::array<const char*, 4> enumNames(Layout) { return {"four-up", "compare", "casts", "oblique"}; }

// LayoutState: how the views lie, which the window remembers.
//   across, down  where the dividers are, as shares of the width and of the height; 0.15 to 0.85
//   compared      the plane of `compare`
struct LayoutState {
  Layout layout = Layout::fourUp;
  float across = 0.5f, down = 0.5f;
  Plane compared = Plane::axial;
};

inline constexpr float kLeastShare = 0.15f, kMostShare = 0.85f;

}  // namespace sonoskin
