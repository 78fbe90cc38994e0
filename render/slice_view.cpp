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

// The uniforms of one layer; `prefix` is "volume" or "overlay".
void setLayer(gl::Program& program, const std::string& prefix, const GpuVolume& volume,
              const SliceFrame& frame) {
  const Geometry& g = volume.geometry();
  const IndexFrame in = indexFrame(frame, g);
  program.set((prefix + "Corner").c_str(), in.corner);
  program.set((prefix + "Right").c_str(), in.right);
  program.set((prefix + "Down").c_str(), in.down);
  program.set((prefix + "Dims").c_str(), volume.empty() ? glm::ivec3(0) : g.dims);
}

// From values to shown = value * x + y.
glm::vec2 windowTerms(const GreyWindow& window) {
  return {1 / window.width, 0.5f - window.level / window.width};
}

void setCrossHair(gl::Program& program, const SliceViewInput& input, const SliceFrame& frame) {
  const glm::vec2 cursor(frame.toPixel(input.camera.cursor));
  program.set("cursor", input.crossHair ? cursor : glm::vec2(-1e6f));
  // A line to the right marks the plane across the downward axis, and the other way round.
  program.set("horizontalColour", planeColour(Plane(axisDown(input.camera.plane))));
  program.set("verticalColour", planeColour(Plane(axisRight(input.camera.plane))));
}

}  // namespace

SliceView::SliceView()
    : plainProgram_({"common/fullscreen.vert", "volume/slice.frag"}),
      overlayProgram_({"common/fullscreen.vert", "volume/slice.frag"}, {"OVERLAY"}) {}

void SliceView::draw(const SliceViewInput& input, const gl::Target& target) {
  const SliceFrame frame = sliceFrame(input.frame, input.camera, target.size);
  const bool overlaid = input.overlay && !input.overlay->empty();
  auto& program = overlaid ? overlayProgram_ : plainProgram_;
  target.bind();
  glDisable(GL_BLEND);
  program.use();
  input.volume.values().bind(0);
  program.set("volume", 0);
  program.set("size", target.size);
  setLayer(program, "volume", input.volume, frame);
  program.set("window", windowTerms(input.window));
  setCrossHair(program, input, frame);
  if (overlaid) {
    input.overlay->values().bind(1);
    program.set("overlay", 1);
    setLayer(program, "overlay", *input.overlay, frame);
    program.set("overlayWindow", windowTerms(input.overlayWindow));
    program.set("overlayColour", input.overlayColour);
    program.set("overlayOpacity", input.overlayOpacity);
  }
  gl::drawFullScreen();
}

}  // namespace sonoskin
