#pragma once

#include <array>
#include <cstddef>

namespace sonoskin {

struct ViewState;

// Tool: what the left button does in a view, in slices and in 3D alike; app/views/use_tool.h uses them.
//   landmark   the next click on the skin places one
//   eraser     what it is dragged over is no surface
//   lasso      what is seen within an outline is no surface, through the whole depth or a part of it
//   measure    clicks set marks between which lengths, angles and areas are measured
//   parts      clicks take parts of the surface away and bring them back, lines split them
//   lamp       the movable light, and the line between two pictures that are compared
//   oblique    the oblique plane's line in the other slices: its ends turn the plane
//   cropBox    the box's sides
//   clipPlane  the plane that cuts what the 3D view shows
//   crossHair  the place where the slices meet; in 3D, where it has no meaning, the camera
enum class Tool { landmark, eraser, lasso, measure, parts, lamp, clipPlane, oblique, cropBox, crossHair };

// kTools: all of them, first what is most in the way: of those that can be used in a view the first one has the button,
// and in this order Escape puts them away.
inline constexpr std::array kTools{Tool::landmark, Tool::eraser,   Tool::lasso,     Tool::measure,
                                   Tool::parts,    Tool::lamp,     Tool::clipPlane, Tool::oblique,
                                   Tool::cropBox,  Tool::crossHair};
static_assert(kTools.size() == std::size_t(Tool::crossHair) + 1);

// toggle: takes a tool for the views of one kind, ViewState::sliceTool or spaceTool, in another's place, or puts it
// away.
void toggle(Tool& chosen, Tool tool);

// isChosen: whether a person has taken the tool, and Escape is to put it away. Lamp and crop box are not chosen: they
// can be used wherever they are shown.
bool isChosen(const ViewState& view, Tool tool);
void putAway(ViewState& view, Tool tool);

}  // namespace sonoskin
