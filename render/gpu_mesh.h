#pragma once

#include <memory>
#include <optional>

#include "core/mesh/mesh.h"
#include "render/gl/buffer.h"

namespace sonoskin {

// GpuMesh: a mesh's copy on the GPU; uploads only where the mesh is another object than the last time.
//   vertex inputs  0: position (mm), 1: unit normal, 2: how well the place is known, visibility times measured (1
//                  where the mesh tells neither)
class GpuMesh {
 public:
  // set: keeps the mesh alive, so that its address stays its name.
  //   errors  Error (system): the driver cannot hold it; then it is empty
  void set(std::shared_ptr<const Mesh> mesh);
  // draw: all triangles, with the program in use.
  void draw() const;

  bool empty() const { return !mesh_ || mesh_->empty(); }
  const Box& box() const { return box_; }

 private:
  void upload(const Mesh& mesh);

  std::shared_ptr<const Mesh> mesh_;
  Box box_;
  std::optional<gl::VertexArray> vertexArray_;
  gl::Buffer positions_, normals_, known_, indices_;
};

}  // namespace sonoskin
