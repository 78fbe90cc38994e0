#include "app/views/space_handles.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "app/views/box_lines.h"
#include "app/views/plane_cut.h"
#include "app/views/projection.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/clip_edits.h"

namespace sonoskin::ui {
namespace {

constexpr float kReach = 9, kRadius = 4,
                kArrow = 40;  // units: to the mouse that takes it; of a handle; along the normal

struct Handle {
  Side side;
  glm::vec3 place, outward;
};

std::vector<Handle> cropHandles(const Workspace& w) {
  const Geometry& g = w.session.scan().volume->geometry;
  const auto ends = boxCorners(w.session.parameters().region, g);
  const glm::dvec3 low = g.toIndex(ends[0]), high = g.toIndex(ends[1]);
  std::vector<Handle> handles;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool far : {false, true}) {
      glm::dvec3 index = 0.5 * (low + high);
      index[axis] = far ? high[axis] : low[axis];
      handles.push_back(
          {{axis, far}, glm::vec3(g.toWorld(index)), glm::vec3(g.direction[axis]) * (far ? 1.f : -1.f)});
    }
  return handles;
}

bool isUnderMouse(const glm::vec3& place, const Workspace& w, const PaneInput& pane) {
  const auto seen = seenAt(place, w.view.camera, pane);
  return seen && glm::distance(*seen, pane.corner + pane.mouse) < kReach * unit();
}

// The handle that the mouse takes: of two the nearer to the eye.
std::optional<Handle> handleUnderMouse(const Workspace& w, const PaneInput& pane) {
  std::optional<Handle> found;
  const glm::vec3 eye = w.view.camera.eye();
  for (const Handle& handle : cropHandles(w))
    if (isUnderMouse(handle.place, w, pane) &&
        (!found || glm::distance(handle.place, eye) < glm::distance(found->place, eye)))
      found = handle;
  return found;
}

bool begins(const PaneInput& input) { return holdsLeft(input) && input.pressed && !input.shift; }

void drawHandle(const glm::vec2& place, bool lit) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 middle{place.x, place.y};
  list.AddCircleFilled(middle, (lit ? 1.5f : 1) * kRadius * unit(), ImGui::GetColorU32(kAccent));
  list.AddCircle(middle, (lit ? 1.5f : 1) * kRadius * unit(), IM_COL32(10, 12, 15, 220), 0, 1.2f * unit());
}

void drawOutline(const Workspace& w, const PaneInput& pane) {
  std::vector<ImVec2> line;
  const Box box = worldBox(w.session.scan().volume->geometry);
  std::array<glm::vec3, 8> corners;
  for (int n = 0; n < 8; ++n)
    corners[std::size_t(n)] = glm::mix(box.min, box.max, glm::bvec3(n & 1, n & 2, n & 4));
  for (const glm::vec3& corner : cutCorners(corners, w.view.clip.plane))
    if (const auto seen = seenAt(corner, w.view.camera, pane)) line.emplace_back(seen->x, seen->y);
  ImVec4 colour = kWarning;
  colour.w = 0.5f;
  ImGui::GetWindowDrawList()->AddPolyline(line.data(), int(line.size()), ImGui::GetColorU32(colour),
                                          ImDrawFlags_Closed, unit());
}

}  // namespace

double alongLine(const glm::vec3& origin, const glm::vec3& direction, const Camera& camera,
                 const PaneInput& pane) {
  const glm::dvec3 ray(rayThrough(pane.mouse, camera, pane)), line(direction), from(origin - camera.eye());
  constexpr double kAside =
      0.06;  // of a line and a ray that meet well enough: the squared sine of their angle
  const double cosine = glm::dot(line, ray), squaredSine = 1 - cosine * cosine;
  if (squaredSine > kAside) return (cosine * glm::dot(ray, from) - glm::dot(line, from)) / squaredSine;
  const double perPixel = double(camera.millimetresPerPixel(int(pane.size.y)));
  return double(pane.mouse.y) * perPixel * (cosine > 0 ? -1 : 1);
}

PaneInput useCropFaces(ToolState& state, Workspace& w, const ToolPane& pane) {
  const PaneInput& input = pane.input;
  if (!state.held && !showsBoxInSpace(w)) return input;
  const Geometry& g = w.session.scan().volume->geometry;
  const auto placeOf = [&](int axis) {
    return alongLine(glm::vec3(g.toWorld(0.5 * glm::dvec3(g.dims - 1))), glm::vec3(g.direction[axis]),
                     w.view.camera, input);
  };
  if (state.held) {
    Parameters parameters = w.session.parameters();
    moveSide(state.drag.side, placeOf(state.drag.side.axis) + state.drag.beyond, parameters.region, g);
    if (parameters.region.cutLow != w.session.parameters().region.cutLow ||
        parameters.region.cutHigh != w.session.parameters().region.cutHigh)
      w.session.edit(parameters);
  } else if (const auto handle = begins(input) ? handleUnderMouse(w, input) : std::nullopt) {
    state.drag = {handle->side,
                  sideAt(handle->side, w.session.parameters().region, g) - placeOf(handle->side.axis)};
    state.held = Tool::cropBox;
  }
  return state.held ? withoutButton(input) : input;
}

PaneInput useClipTool(ToolState& state, Workspace& w, const ToolPane& pane) {
  const PaneInput& input = pane.input;
  const glm::vec3 normal = w.view.clip.plane.normal, middle = clipMiddle(w) - clipDepth(w) * normal;
  const double place = alongLine(middle, normal, w.view.camera, input);
  if (state.held) {
    moveClip(w, float(place + state.drag.beyond));
  } else if (begins(input) && isUnderMouse(clipMiddle(w), w, input)) {
    state.drag.beyond = double(clipDepth(w)) - place;
    state.held = Tool::clipPlane;
  }
  return state.held ? withoutButton(input) : input;
}

void drawCropHandles(const ToolState& state, const Workspace& w, const PaneInput& pane) {
  const bool held = state.held == Tool::cropBox;
  const bool shown =
      pane.hovered || held || w.step == Step::region;  // a picture that is looked at has no dots
  const auto under = pane.hovered && !state.held ? handleUnderMouse(w, pane) : std::nullopt;
  for (const Handle& handle : cropHandles(w)) {
    const auto seen = seenAt(handle.place, w.view.camera, pane);
    if (!seen) continue;
    const Side& lit = held ? state.drag.side : under ? under->side : Side{-1, false};
    if (shown) drawHandle(*seen, handle.side.axis == lit.axis && handle.side.high == lit.high);
    notePlace(fmt::format("crop.{}{}", "ijk"[handle.side.axis], handle.side.high ? "+" : "-"), *seen,
              kRadius * unit());
  }
}

void drawClipHandle(const ToolState& state, const Workspace& w, const PaneInput& pane) {
  drawOutline(w, pane);
  const Camera& camera = w.view.camera;
  const glm::vec3 middle = clipMiddle(w);
  const float length = kArrow * unit() * camera.millimetresPerPixel(int(pane.size.y));
  const auto from = seenAt(middle, camera, pane),
             to = seenAt(middle - length * w.view.clip.plane.normal, camera, pane);
  if (!from || !to) return;
  const bool lit =
      state.held == Tool::clipPlane || (pane.hovered && !state.held && isUnderMouse(middle, w, pane));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = ImGui::GetColorU32(kWarning);
  list.AddLine({from->x, from->y}, {to->x, to->y}, colour, (lit ? 2.5f : 1.6f) * unit());
  const glm::vec2 along = *to - *from;
  if (const float pixels = glm::length(along); pixels > 8 * unit()) {
    const glm::vec2 ahead = along / pixels * 7.f * unit(), aside(-0.5f * ahead.y, 0.5f * ahead.x);
    const glm::vec2 a = *to - ahead + aside, b = *to - ahead - aside;
    list.AddTriangleFilled({to->x, to->y}, {a.x, a.y}, {b.x, b.y}, colour);
  }
  list.AddCircleFilled({from->x, from->y}, (lit ? 1.5f : 1) * kRadius * unit(), colour);
  notePlace("clip.handle", *from, kRadius * unit());
}

}  // namespace sonoskin::ui
