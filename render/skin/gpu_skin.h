#pragma once

#include <memory>
#include <optional>

#include "render/gl/buffer.h"
#include "render/gl/texture.h"
#include "render/skin/skin_view.h"

namespace sonoskin {

// GpuSkin::Parts: what the passes read.
//   vertex inputs  0: position (mm), 1: unit normal, 2: place in the atlas, 0 to 1, 3: measured
//   position       rgba32f: mm; 1 owned, 0.5 skirt, 0 nothing;  normal: unit, mean curvature;  open: bent normal, share of
//                  open sky;  stretch: mm per texel;  charts: number of the chart
struct GpuSkin::Parts {
  std::shared_ptr<const SkinSurface> surface;
  std::uint64_t number = 0;  // of the surface: every one that is set anywhere gets another
  Box box;
  std::optional<gl::VertexArray> vertexArray;
  gl::Buffer positions, normals, uvs, measured, indices;
  struct Hidden {
    gl::Buffer positions, normals, indices;
    std::optional<gl::VertexArray> array;
  };
  Hidden hidden;  // what is not in the atlas, with inputs 0 and 1
  struct Drawn {
    gl::Buffer corners;
    std::optional<gl::VertexArray> array;
    int vertices = 0;

    void upload(const std::vector<glm::vec2>& places);
    void draw() const;
  };
  Drawn covered, shown;
  gl::Texture position, normal, open, stretch;

  void upload();
  void uploadHidden();
  void drawFirst(std::size_t triangles) const;
  // draw: the triangles that are shown, with the program in use; drawAll: those from which light spreads to them, too.
  void draw() const;
  void drawAll() const;
  // hides: whether there is more of the surface; drawHidden: that part, with the program in use.
  bool hides() const { return surface && !surface->hidden.empty(); }
  void drawHidden() const;
  // drawAtlas: the parts of the atlas that show something, with a program of skin/atlas.vert: half of it is empty.
  void drawAtlas() const { covered.draw(); }
  // drawShown: those that pictures read; without skirts a third less.
  void drawShown() const { shown.draw(); }
  glm::ivec2 atlasSize() const { return surface->maps.size; }
  std::size_t bytes() const;
};

// chartNumbers: the number of the owning chart per texel, to be looked at.
gl::Texture chartNumbers(const SkinSurface& surface);

}  // namespace sonoskin
