#include "app/views/orientation_cube.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <optional>
#include <string>

#include "app/texts/texts.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {
namespace {

constexpr float kHalf = 21;  // of an edge

// Side: one face of the cube: its outward direction and two edges, unit, world; what is written on it; its colour is that
// of the plane that it is parallel to.
struct Side {
  glm::dvec3 outward, across, along;
  const char *name, *id;
  ImVec4 colour;
};
using Sides = std::array<Side, 6>;

Sides sidesOf(const ViewFrame& frame) {
  const bool patient = frame.isPatient;
  // A scanner's cube follows the beam, which may be oblique to the volume's axes.
  const glm::dvec3 y = frame.forward,
                   z = patient ? frame.up : glm::normalize(glm::cross(frame.forward, frame.up));
  const glm::dvec3 x = patient ? glm::dvec3(1, 0, 0) : -frame.up;
  constexpr std::array<const char*, 6> kPatient{"R", "L", "A", "P", "I", "S"},
      kScanner{"top", "bottom", "probe", "deep", "left", "right"};
  const auto& names = patient ? kPatient : kScanner;
  const auto text = [&](int n) { return patient ? names[std::size_t(n)] : tr(names[std::size_t(n)]); };
  const auto side = [&](int n, const glm::dvec3& outward, const glm::dvec3& across, const glm::dvec3& along) {
    const std::array<ImVec4, 3> colours{kSagittal, kCoronal, kAxial};
    return Side{outward, across, along, text(n), names[std::size_t(n)], colours[std::size_t(n / 2)]};
  };
  return {side(0, -x, y, z), side(1, x, y, z),  side(2, -y, x, z),
          side(3, y, x, z),  side(4, -z, x, y), side(5, z, x, y)};
}

// Seen: the cube as the camera has it, without perspective.
struct Seen {
  glm::vec2 middle;
  glm::mat3 view;
  float half;

  glm::vec2 place(const glm::dvec3& world) const {
    const glm::vec3 p = view * glm::vec3(world);
    return middle + half * glm::vec2(p.x, -p.y);
  }
  float toward(const Side& side) const { return (view * glm::vec3(side.outward)).z; }
  std::array<glm::vec2, 4> corners(const Side& s) const {
    return {place(s.outward - s.across - s.along), place(s.outward + s.across - s.along),
            place(s.outward + s.across + s.along), place(s.outward - s.across + s.along)};
  }
};

Seen seenCube(const PaneInput& pane, const Camera& camera) {
  const float u = unit();
  return {
      {pane.corner.x + 52 * u, pane.corner.y + pane.size.y - 52 * u}, glm::mat3(camera.view()), kHalf * u};
}

bool isInside(const std::array<glm::vec2, 4>& corners, const glm::vec2& p) {
  int left = 0, right = 0;
  for (std::size_t n = 0; n < 4; ++n) {
    const glm::vec2 edge = corners[(n + 1) % 4] - corners[n], to = p - corners[n];
    (edge.x * to.y - edge.y * to.x > 0 ? left : right) += 1;
  }
  return left == 0 || right == 0;
}

constexpr float kLeastToward = 0.12f;  // a face that is seen from its edge is none

std::optional<Side> sideBelow(const ViewFrame& frame, const PaneInput& pane, const Camera& camera) {
  const Seen seen = seenCube(pane, camera);
  for (const Side& side : sidesOf(frame))
    if (seen.toward(side) > kLeastToward && isInside(seen.corners(side), pane.corner + pane.mouse))
      return side;
  return std::nullopt;
}

void drawSide(const Seen& seen, const Side& side, bool lit) {
  const auto c = seen.corners(side);
  const auto at = [&](std::size_t n) { return ImVec2(c[n].x, c[n].y); };
  const float shade = (lit ? 0.30f : 0.12f) + 0.10f * seen.toward(side);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddQuadFilled(at(0), at(1), at(2), at(3),
                     ImGui::GetColorU32({shade, shade * 1.03f, shade * 1.08f, 0.9f}));
  list.AddQuad(at(0), at(1), at(2), at(3), ImGui::GetColorU32({0.45f, 0.48f, 0.52f, 0.8f}), unit());
  const glm::vec2 middle = seen.place(side.outward);
  notePlace(std::string("cube.") + side.id, middle, 2 * unit());
  if (seen.toward(side) < 0.35f) return;
  ImFont* font = side.name[1] == '\0' ? headingFont() : smallFont();
  const float wide = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, side.name).x;
  const float height =
      font->FontSize * std::min(1.0f, 1.9f * kHalf * unit() / wide);  // long words are smaller
  const ImVec2 size = font->CalcTextSizeA(height, FLT_MAX, 0, side.name);
  ImVec4 colour = side.colour;
  colour.w = std::min(1.0f, 1.3f * seen.toward(side));
  list.AddText(font, height, {middle.x - 0.5f * size.x, middle.y - 0.5f * size.y}, ImGui::GetColorU32(colour),
               side.name);
}

}  // namespace

void lookFrom(const glm::dvec3& side, const ViewFrame& frame, Camera& camera) {
  const glm::dvec3 up = frame.turned(frame.up);
  camera.forward = glm::vec3(-side);
  // From above and from below the front is shown upward.
  const glm::dvec3 upward = std::abs(glm::dot(side, up)) > 0.9 ? -frame.turned(frame.forward) : up;
  camera.up = glm::cross(rightOf(camera.forward, glm::vec3(upward)), camera.forward);
}

PaneInput useCube(OrientationCube& cube, const ViewFrame& frame, const PaneInput& pane, Camera& camera,
                  bool& moved) {
  if (pane.button != ImGuiMouseButton_Left) cube.held = false;
  if (cube.held) return withoutButton(pane);
  if (!pane.pressed || !holdsLeft(pane) || pane.shift) return pane;
  const auto side = sideBelow(frame, pane, camera);
  if (!side) return pane;
  lookFrom(side->outward, frame, camera);
  cube.held = moved = true;
  return withoutButton(pane);
}

void drawCube(const OrientationCube& cube, const ViewFrame& frame, const PaneInput& pane,
              const Camera& camera) {
  const Seen seen = seenCube(pane, camera);
  const bool free = pane.hovered && pane.button < 0 && !cube.held;
  const auto below = free ? sideBelow(frame, pane, camera) : std::nullopt;
  for (const Side& side : sidesOf(frame))
    if (seen.toward(side) > kLeastToward) drawSide(seen, side, below && below->id == std::string(side.id));
}

}  // namespace sonoskin::ui
