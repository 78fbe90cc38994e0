#include "app/workspace/view_file.h"

#include "app/workspace/view_fields.h"
#include "app/workspace/view_json.h"

namespace sonoskin {
namespace {

// Whether a camera's directions can be drawn with.
bool isUpright(const Camera& camera) {
  constexpr float kClose = 1e-3f;
  return std::abs(glm::length(camera.forward) - 1) < kClose &&
         std::abs(glm::length(camera.up) - 1) < kClose &&
         std::abs(glm::dot(camera.forward, camera.up)) < kClose;
}

// Whether a matrix turns, and does nothing else.
bool isTurn(const glm::dmat3& m) {
  const glm::dmat3 product = glm::transpose(m) * m;
  double off = 0;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) off = std::max(off, std::abs(product[c][r] - (c == r ? 1.0 : 0.0)));
  return off < 1e-6;
}

}  // namespace

std::string writeViews(const ViewState& view) { return view_json::write(view).dump(); }

void readViews(const std::string& json, ViewState& view) {
  const Camera before = view.camera;
  const Orientation turned = view.orientation;
  view_json::read(view_json::Json::parse(json, nullptr, false), view);
  if (!isUpright(view.camera)) view.camera = before;
  if (!isTurn(view.orientation.turn)) view.orientation = turned;
}

}  // namespace sonoskin
