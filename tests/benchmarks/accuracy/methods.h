#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/pipeline/parameters.h"
#include "core/surface/surface_points.h"
#include "core/volume/scan.h"

namespace sonoskin::accuracy {

// Finding: what a method found, and the iso-value it used (0: none).
struct Finding {
  SurfacePoints points;
  double isoValue = 0;
};

// Method: a way from a volume to oriented points.
struct Method {
  std::string name;  // a word for the command line
  std::string help;  // what it does, for the table
  std::function<Finding(const Scan&, const Parameters&)> find;
};

// ownMethods: the program's chain as it stands, and with parts of it taken away.
std::vector<Method> ownMethods();

// rivals: simple ways to the same. Each gets our facing filter, our margin at the sector's border, and pieces of at
// least 100 voxels.
std::vector<Method> rivals();
std::vector<Method> itkRivals();

}  // namespace sonoskin::accuracy
