#pragma once

#include <optional>
#include <string>

#include "core/base/progress.h"
#include "core/pipeline/pipeline.h"
#include "render/pictures.h"
#include "render/skin/skin_pictures.h"

namespace sonoskin {

// VolumeShown: how a volume is ray-cast.
//   mode      "iso": the first hit; "dvr": translucent; "mip": the largest value along each ray
//   transfer  of dvr: a preset or a file
//   level     grey of the skin's border, 0 to 1; 0: found from the volume
//   whole     not only the box around the surface that was found
struct VolumeShown {
  std::string mode = "dvr", transfer = "amber";
  double level = 0;
  bool whole = false, shadows = true, withMesh = false;
};

// lookOf: the same for a picture.
//   level   grey of the skin's border
//   errors  Error: the transfer function is neither a preset nor a file of one
VolumePictureOptions lookOf(const VolumeShown& shown, float level);

// ScanView: what a picture of a scan shows, and from where.
//   view   "skin" or "mesh": the surface; "volume"; "slices": raw, classified and thinned in three planes; "slice": one of them
//   layer  of volume and slice: "raw", "classified", or of a slice "thinned"
//   plane  of a slice: "axial", "sagittal" or "coronal"; a scanner's A, B, C
//   at     where a slice lies, world mm; without it, in the middle of what is bright
struct ScanView {
  std::string view = "skin", layer, plane = "axial";
  std::optional<glm::dvec3> at{};
  VolumeShown volume{};
  SkinPictureOptions skin{};
  PictureOptions picture{};
};

// layerOf: the view's, or what it shows where none is said: the classified volume in a slice, the raw one in 3D.
std::string layerOf(const ScanView& view);

// goalOf: how far the pipeline has to go for a picture; empty: not at all.
std::optional<Goal> goalOf(const ScanView& view);

// requireWithin: refuses, before any work but reading, slices through a place outside of the scan.
//   errors  Error (usage), with what the scan fills
void requireWithin(const Scan& scan, const ScanView& view);

// ScanMade: a scan and what the pipeline has made of it.
struct ScanMade {
  Scan scan;
  Results results;
  Parameters parameters;
};

// SurfaceShot: a surface as a view shows it, with what is known of its face: where it is looked at from, and landmarks.
struct SurfaceShot {
  std::shared_ptr<const Mesh> mesh;
  Parameters parameters;
  ScanView view;
};
SurfaceShot surfaceShot(const ScanMade& made, const ScanView& view);

// pictureOfScan: one picture, or those of a turntable.
//   made    results as far as goalOf() asks for
//   errors  as the functions of render/pictures.h and render/skin/skin_pictures.h; Cancelled
Image pictureOfScan(gl::Context& context, ScanMade made, const ScanView& view, const Progress& progress = {});

// pictureOfSurface: the same of a surface alone, as "mesh" or "skin".
Image pictureOfSurface(gl::Context& context, const SurfaceShot& shot, const Progress& progress = {});

}  // namespace sonoskin
