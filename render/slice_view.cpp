#include "render/slice_view.h"

#include <glad/gl.h>

#include <array>

namespace sonoskin {
namespace {

// Where the pixels of a frame lie in a volume, in voxel indices.
struct IndexFrame {
  glm::vec3 corner, right, down;
};

IndexFrame indexFrame(const SliceFrame& frame, const Geometry& geometry) {
  const glm::dmat3 toAxes = glm::transpose(geometry.direction);
  return {glm::vec3(geometry.toIndex(frame.corner)), glm::vec3(toAxes * frame.right / geometry.spacing),
          glm::vec3(toAxes * frame.down / geometry.spacing)};
}

// The uniforms of one layer; `prefix` is "volume", "overlay" or "erased".
void setLayer(gl::Program& program, const std::string& prefix, const Geometry& g, const SliceFrame& frame) {
  const IndexFrame in = indexFrame(frame, g);
  program.set((prefix + "Corner").c_str(), in.corner);
  program.set((prefix + "Right").c_str(), in.right);
  program.set((prefix + "Down").c_str(), in.down);
  program.set((prefix + "Dims").c_str(), g.dims);
}

Geometry geometryOf(const GpuVolume& volume) { return volume.empty() ? Geometry{} : volume.geometry(); }

// Coloured: a volume that is shown in a colour over the grey.
struct Coloured {
  const GpuVolume& volume;
  GreyWindow window;
  glm::vec3 colour;
  float opacity;
};

void setColoured(gl::Program& program, const std::string& prefix, int unit, const Coloured& layer,
                 const SliceFrame& frame) {
  layer.volume.values().bind(unsigned(unit));
  program.set(prefix.c_str(), unit);
  setLayer(program, prefix, geometryOf(layer.volume), frame);
  program.set((prefix + "Window").c_str(), layer.window.terms());
  program.set((prefix + "Colour").c_str(), layer.colour);
  program.set((prefix + "Opacity").c_str(), layer.opacity);
}

void setCrossHair(gl::Program& program, const SliceViewInput& input, const SliceFrame& frame) {
  const glm::vec2 cursor(frame.toPixel(input.camera.cursor));
  program.set("cursor", input.crossHair && !input.camera.oblique ? cursor : glm::vec2(-1e6f));
  // A line to the right marks the plane across the downward axis, and the other way round.
  const PlaneAxes& planes = input.camera.planes;
  const SliceAxes& axes = input.camera.axes();
  program.set("horizontalColour", planeColour(planes.across(axes.down)));
  program.set("verticalColour", planeColour(planes.across(axes.right)));
}

// The box in the picture: pixels from the left, top, right, bottom; nothing of it where the slice misses it.
void setBox(gl::Program& program, const SliceViewInput& input, const SliceFrame& frame) {
  glm::vec4 box(-1e9f, -1e9f, 1e9f, 1e9f);
  if (input.box && !input.camera.oblique) {
    const auto& [low, high] = *input.box;
    const int across = input.camera.axes().across;
    const double at = input.frame.toIndex(input.camera.cursor)[across];
    const bool cuts = at >= input.frame.toIndex(low)[across] && at <= input.frame.toIndex(high)[across];
    const glm::vec2 a(frame.toPixel(low)), b(frame.toPixel(high));
    box = cuts ? glm::vec4(glm::min(a, b), glm::max(a, b)) : glm::vec4(1e9f, 1e9f, -1e9f, -1e9f);
  }
  program.set("box", box);
}

}  // namespace

gl::Program& SliceView::programFor(bool overlaid, bool erased, bool tinted) {
  auto& program = programs_[std::size_t(overlaid) + 2 * std::size_t(erased) + 4 * std::size_t(tinted)];
  if (!program) {
    std::vector<std::string> defines;
    if (overlaid) defines.push_back("OVERLAY");
    if (erased) defines.push_back("ERASED");
    if (tinted) defines.push_back("TINT");
    program.emplace(std::vector<std::string>{"common/fullscreen.vert", "volume/slice.frag"}, defines);
  }
  return *program;
}

void SliceView::draw(const SliceViewInput& input, const gl::Target& target) {
  const SliceFrame frame = sliceFrame(input.frame, input.camera, target.size);
  const bool overlaid = input.overlay && !input.overlay->empty();
  const bool erased = input.erased && *input.erased;
  const bool tinted = input.tint && !input.tint->empty();
  auto& program = programFor(overlaid, erased, tinted);
  target.bind();
  glDisable(GL_BLEND);
  program.use();
  input.volume.values().bind(0);
  program.set("volume", 0);
  program.set("size", target.size);
  setLayer(program, "volume", geometryOf(input.volume), frame);
  program.set("window", input.window.terms());
  setCrossHair(program, input, frame);
  setBox(program, input, frame);
  if (overlaid)
    setColoured(program, "overlay", 1,
                {*input.overlay, input.overlayWindow, input.overlayColour, input.overlayOpacity}, frame);
  if (tinted)
    setColoured(program, "tint", 3, {*input.tint, input.tintWindow, input.tintColour, input.tintOpacity},
                frame);
  if (erased) {
    input.erased->texture().bind(2);
    program.set("erased", 2);
    setLayer(program, "erased", input.frame, frame);
    program.set("erasedColour", input.erasedColour);
  }
  gl::drawFullScreen();
}

}  // namespace sonoskin
