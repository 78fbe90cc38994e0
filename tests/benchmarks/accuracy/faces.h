#pragma once

#include <string>
#include <vector>

#include "tests/benchmarks/accuracy/settings.h"

namespace CLI {
class App;
}

namespace sonoskin::accuracy {

// FacesOptions: which simulated babies, and what is written beside the tables. A case is called scene-shape-seed.
//   scenes, shapes, seeds   empty: what --set says, else every scene, shapes 0 to 4, seeds 1 and 2
//   csv          a file for one line for each run
//   exportTo     a folder for the volumes, <case>.nrrd, and their truth, <case>-truth.ply
//   pointsTo     a folder for the oriented points that the surface is fitted to, <case>.ply
//   keepTo       a folder for the meshes, <case>.ply
//   meshesFrom   a folder of meshes to judge, <case>.ply, instead of making them; empty: they are made
struct FacesOptions {
  std::vector<std::string> scenes;
  std::vector<int> shapes, seeds;
  std::string csv, exportTo, pointsTo, keepTo, meshesFrom;
};

// addOptions: those of the command line.
void addOptions(CLI::App& app, FacesOptions& options);

// printFaceTables: runs the whole pipeline on every case, 256x144x72 voxels unless others are given, and prints how good
// the meshes are (faces_score.h), as Markdown. A case without a surface is named on standard error and counts as nothing
// covered.
//   sweep    "group.field=value,value,...", or empty: every case once for each value, which becomes part of the names of
//            the files. Stages that do not depend on the parameter are not repeated, and the seconds are without them.
//   errors   Error: an unknown scene or parameter, a file that cannot be read or written
void printFaceTables(const FacesOptions& options, const Given& given, const std::string& sweep);

}  // namespace sonoskin::accuracy
