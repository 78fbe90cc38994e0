#pragma once

#include <memory>
#include <vector>

#include "app/workspace/objects_seen.h"
#include "core/volume/volume.h"

namespace sonoskin {

struct Workspace;

// shownVolume: what the 3D view shows as a volume: the classified one where it is asked for and there, else the scan.
std::shared_ptr<const Volume<float>> shownVolume(const Workspace& workspace);

// VolumeHistogram: how often values occur in a volume, as heights of bars; counted once for each volume.
class VolumeHistogram {
 public:
  // of: 256 heights for values from 0 to 1, by the logarithm of the count, 0 to 1.
  const std::vector<float>& of(const std::shared_ptr<const Volume<float>>& volume);

 private:
  ObjectsSeen<1> seen_;
  std::vector<float> heights_;
};

}  // namespace sonoskin
