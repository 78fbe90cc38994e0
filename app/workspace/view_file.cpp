#include "app/workspace/view_file.h"

#include <algorithm>
#include <cmath>

#include "app/document/measure_file.h"
#include "app/workspace/view_fields.h"
#include "app/workspace/view_json.h"

namespace sonoskin {
namespace {

static_assert(view_json::kMostElements >= std::max(kMostMeasures, kMostMarks));

// Whether a camera's directions can be drawn with.
bool isUpright(const Camera& camera) {
  constexpr float kClose = 1e-3f;
  return std::abs(glm::length(camera.forward) - 1) < kClose &&
         std::abs(glm::length(camera.up) - 1) < kClose &&
         std::abs(glm::dot(camera.forward, camera.up)) < kClose;
}

// Whether a plane's directions can be drawn with.
bool isPlane(const PlaneDirections& plane) {
  constexpr double kClose = 1e-6;
  return std::abs(glm::length(plane.right) - 1) < kClose && std::abs(glm::length(plane.down) - 1) < kClose &&
         std::abs(glm::dot(plane.right, plane.down)) < kClose;
}

// A transfer function of one's own that can be drawn: the preset's takes its place else.
bool isDrawable(const TransferFunction& transfer) {
  return transfer.points.size() >= 2 &&
         std::ranges::is_sorted(transfer.points, {}, &TransferFunction::Point::value);
}

}  // namespace

std::string writeViews(const ViewState& view) { return view_json::write(view).dump(); }

Key marksKey(const ViewState& view) {
  if (view.measures.empty()) return {};
  return Hasher("marks").add(view_json::write(view.measures).dump()).key();
}

void readViews(const std::string& json, ViewState& view) {
  const Camera before = view.camera;
  const Orientation turned = view.orientation;
  const ObliqueShow oblique = view.oblique;
  view_json::read(view_json::Json::parse(json, nullptr, false), view);
  view.linkedScale = 0;
  if (!isUpright(view.camera)) view.camera = before;
  if (!isPlane(view.oblique.directions)) view.oblique = oblique;
  if (!isQuarterTurn(view.orientation.turn)) view.orientation = turned;
  std::erase_if(view.measures, [](const Measure& measure) { return !isComplete(measure); });
  if (view.volume.own && !isDrawable(view.volume.own->function)) view.volume.own.reset();
  if (std::abs(glm::length(view.clip.plane.normal) - 1) > 1e-3f) view.clip = {};
}

}  // namespace sonoskin
