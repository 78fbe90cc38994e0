#pragma once

#include <span>
#include <string_view>

#include "render/transfer_function.h"

namespace sonoskin {

// TransferPreset: a transfer function that follows the grey value at the border of the skin.
struct TransferPreset {
  const char* name;
  TransferFunction (*at)(float iso);
};

// transferPresets: amber, skin, bone, grey.
std::span<const TransferPreset> transferPresets();
// findTransferPreset: the one of that name, null for none.
const TransferPreset* findTransferPreset(std::string_view name);

// skinTransfer: a surface almost as dense as skin where it begins, in its colour.
TransferFunction skinTransfer(float iso);

// boneTransfer: soft tissue a faint veil, what is much brighter than skin dense and ivory.
TransferFunction boneTransfer(float iso);

// LevelledTransfer: a transfer function that somebody made for a scan whose skin begins at a grey value; others move it
// with theirs.
//   level  0 to 1
struct LevelledTransfer {
  TransferFunction function;
  float level = 0.5f;

  // at: for a scan with another level: all points moved by the difference, within 0 to 1.
  TransferFunction at(float other) const;
  friend bool operator==(const LevelledTransfer&, const LevelledTransfer&) = default;
};

}  // namespace sonoskin
