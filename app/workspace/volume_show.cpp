#include "app/workspace/volume_show.h"

namespace sonoskin {

TransferFunction VolumeShow::transfer(float level) const {
  if (own) return own->at(level);
  const TransferPreset* preset = findTransferPreset(colours);
  return (preset ? preset : &transferPresets().front())->at(level);
}

}  // namespace sonoskin
