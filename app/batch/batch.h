#pragma once

#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "app/batch/report.h"
#include "app/document/input.h"
#include "core/base/progress.h"
#include "core/io/mesh_writer.h"
#include "core/pipeline/pipeline.h"
#include "core/skin/skin_surface.h"
#include "render/gl/context.h"

namespace sonoskin {

// Bake: whether a surface is written with the maps of its skin too, or with the light on it.
enum class Bake { none, colour, light };
constexpr std::array<const char*, 3> enumNames(Bake) { return {"none", "colour", "light"}; }

// BatchOptions: one run without a window.
//   inputName  what the report may call the input; empty: by its fingerprint
//   bake    of those of the mesh's formats that hold pictures (glb, obj)
struct BatchOptions {
  InputFiles input;
  std::filesystem::path folder;
  std::string inputName{};
  Parameters parameters;
  std::vector<std::string> meshFormats{"ply"};  // without dots
  MeshFileOptions meshFile{};
  bool keepScan = false, keepClassified = false, keepThinned = false, keepPoints = false;
  std::string volumeFormat = "nrrd";  // of what is kept; without a dot
  glm::ivec2 pictureSize{1280, 960};
  bool turnsFormat = true;  // pictures of what is taller than wide are upright, of the same size
  Bake bake = Bake::none;
  SkinQuality skinQuality = pictureQuality();
  gl::Backend backend = gl::Backend::egl;
};

// runBatch: the whole way from a volume to a folder with mesh.<format>, skin.png, mesh.png, volume.png,
// slices.png, recipe.json and report.json; of the phantom truth.ply too; on request scan, its
// scan_mask where there is one, classified and thinned as volumes, points.ply; print.stl (and print.3mf with that format) if print.form is not none; skin.glb and
//   skin.obj (with its material and pictures) if something is baked.
//   stageBegins  called with a word for people as each stage starts
//   order        first all but the pictures and what is baked, as one set with a report; then those, with the report anew.
//                Files of an earlier run that the set has none of go with it
//   errors       Error: bad input, nothing found, the folder cannot be written; Cancelled. The folder and the results of
//                earlier runs in it are as before then, unless the first set was complete: then it stands
Report runBatch(const BatchOptions& options, const Progress& progress = {},
                const Pipeline::StageBegins& stageBegins = {});

}  // namespace sonoskin
