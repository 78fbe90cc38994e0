#pragma once

#include <string>

#include "core/volume/scan.h"
#include "render/slice_view.h"

namespace sonoskin {

// automaticWindow: from the value that 1 percent of the voxels are darker than, to that which 1 percent are brighter than.
GreyWindow automaticWindow(const Volume<float>& volume);

// isCt: whether a scan's values are those of a CT, for which there are windows in Hounsfield units.
bool isCt(const Scan& scan);

// hounsfieldWindow: a window of a CT as radiologists name it, by its middle and width. Where the file's values begin at 0 they
// are taken for Hounsfield units plus 1024, as scanners store them.
GreyWindow hounsfieldWindow(const Scan& scan, double level, double width);

// windowText: width and level in the file's own values: "window 400  level 40".
std::string windowText(const Scan& scan, const GreyWindow& window);

}  // namespace sonoskin
