#pragma once

#include <string>
#include <vector>

#include "core/phantom/phantom.h"

namespace sonoskin::accuracy {

// Level: one of the five noise levels, A (good) to E (poor).
struct Level {
  std::string name;
  double snr;  // dB, phantom.snr
};

// noiseLevels: chosen so that the contrast-to-noise ratios are those of the figures that the bars come from:
// 6.5, 6.2, 5.0, 4.5, 3.9. Those scans were made by another simulation: A had averaged speckle, ours never has.
const std::vector<Level>& noiseLevels();

// ContrastMeter: measures the contrast-to-noise ratio as core/phantom/phantom.h defines it.
class ContrastMeter {
 public:
  explicit ContrastMeter(const PhantomOptions& options);
  double measure(const Volume<float>& volume) const;

 private:
  std::vector<std::size_t> skin_, fluid_;  // voxels of each
};

}  // namespace sonoskin::accuracy
