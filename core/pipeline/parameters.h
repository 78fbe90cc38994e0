#pragma once

#include <string_view>

#include "core/classification/classification_options.h"
#include "core/enhancement/enhancement_options.h"
#include "core/face/face_options.h"
#include "core/io/raw_options.h"
#include "core/mesh/mesh_options.h"
#include "core/mesh/print/print_options.h"
#include "core/phantom/phantom_options.h"
#include "core/rbf/global/global_options.h"
#include "core/rbf/reconstruction_options.h"
#include "core/skin/landmark_options.h"
#include "core/skin/light_options.h"
#include "core/skin/skin_options.h"
#include "core/surface/region_options.h"
#include "core/surface/surface_options.h"
#include "core/volume/scan_options.h"

namespace sonoskin {

// Parameters: everything that a recipe holds.
struct Parameters {
  PhantomOptions phantom;
  ScanOptions scan;
  RawOptions raw;
  EnhancementOptions enhancement;
  ClassificationOptions classification;
  RegionOptions region;
  SurfaceOptions surface;
  ReconstructionOptions reconstruction;
  GlobalOptions global;
  MeshOptions mesh;
  PrintOptions print;
  SkinOptions skin;
  LightOptions light;
  LandmarkOptions landmarks;
  FaceOptions face;
};

// Group: the heading of one algorithm's parameters.
struct Group {
  std::string_view name;
  std::string_view help;
};

// groups: calls f(Group, options) for every group, in the order of the pipeline.
template <class F, class P>
requires OptionsOf<P, Parameters>
void groups(F&& f, P& p) {
  f(Group{"phantom", "the simulated scan"}, p.phantom);
  f(Group{"scan", "how the volume was recorded"}, p.scan);
  f(Group{"raw", "what a file without a header holds"}, p.raw);
  f(Group{"enhancement", "less speckle before anything else"}, p.enhancement);
  f(Group{"classification", "finding surfaces in the noise"}, p.classification);
  f(Group{"region", "the part of the volume that counts"}, p.region);
  f(Group{"surface", "from surfaces to points"}, p.surface);
  f(Group{"reconstruction", "fitting a smooth surface to the points"}, p.reconstruction);
  f(Group{"global", "one function through all points, for reconstruction.method = global"}, p.global);
  f(Group{"mesh", "the triangles"}, p.mesh);
  f(Group{"print", "a solid to print"}, p.print);
  f(Group{"skin", "what the skin is made of; changes the pictures alone"}, p.skin);
  f(Group{"light", "the lights on the skin; changes the pictures alone"}, p.light);
  f(Group{"landmarks", "places of the face, for the colour of lips, lids and cheeks"}, p.landmarks);
  f(Group{"face", "where the face is"}, p.face);
}

// forEachField: calls f(Group, Field, member&, Range...) for every parameter.
template <class F, class P>
requires OptionsOf<P, Parameters>
void forEachField(F&& f, P& p) {
  groups(
      [&](const Group& group, auto& options) {
        fields([&](const Field& field, auto& member, auto... range) { f(group, field, member, range...); },
               options);
      },
      p);
}

}  // namespace sonoskin
