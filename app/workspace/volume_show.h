#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/document/view_edits.h"
#include "render/transfer_presets.h"

namespace sonoskin {

enum class VolumeStyle { surface, translucent, maximum };

// VolumeShow: how the 3D view shows a volume that is translucent.
//   colours   the transfer function's name: a preset's, or that of one of the person's own
//   own       the function as the person made or loaded it; without one the preset's
//   changed   since it had its name
//   shadows   see RaycastInput
//   mesh      the surface within it
//   edited    its editor is open
//   name      that is being given to it
//   selected  of the function's points, that is edited; -1: none
struct VolumeShow {
  std::string colours = "amber";
  std::optional<LevelledTransfer> own;
  bool changed = false, shadows = true, mesh = false, edited = false;
  std::string name;
  int selected = -1;

  // transfer: for a scan whose skin begins at a grey value, 0 to 1.
  TransferFunction transfer(float level) const;
};

}  // namespace sonoskin
