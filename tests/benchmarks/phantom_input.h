#pragma once

#include "core/phantom/phantom.h"

namespace sonoskin {

// phantomInput: the simulated scan at full size, 467x255x124, made once: what every stage is measured on.
inline const Scan& phantomInput() {
  static const Scan scan = makePhantomScan(PhantomOptions{});
  return scan;
}

}  // namespace sonoskin
