#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/io/image.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// TexturedMesh: a surface with pictures on it. Of the mesh, vertices lie apart where the pictures have a seam.
//   uv       per vertex, 0 to 1 over the pictures, from their lower left corner
//   colour   sRGB: the surface's own colour, or the light that it sends out where `lit`
//   normals  tangent space as in glTF: red along u, green upward along v, 0.5 is 0; empty where `lit`
//   finish   as in glTF: green roughness, blue metalness, linear; empty where `lit`
struct TexturedMesh {
  Mesh mesh;
  std::vector<glm::vec2> uv;
  Image colour, normals, finish;
  bool lit = false;
};

// writeTexturedMesh: GLB holds the pictures; an OBJ has a material file and pictures beside it: face.obj, face.mtl,
// face_colour.png, face_normal.png, face_roughness.png. They appear together. Units and frames as writeMesh; a lit
// surface is unlit for the viewer (KHR_materials_unlit).
//   output   the names of the files, that of `path` first
//   errors   Error (usage): another extension; Error: no triangles, arrays or pictures that do not fit; (system) the
//            files cannot be written; Cancelled
std::vector<std::string> writeTexturedMesh(const std::filesystem::path& path, const TexturedMesh& surface,
                                           const Progress& progress = {});

}  // namespace sonoskin
