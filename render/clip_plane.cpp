#include "render/clip_plane.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/error.h"

namespace sonoskin {
namespace {

struct ClipSide {
  std::string_view name;
  glm::vec3 direction;
};
constexpr std::array kSides{ClipSide{"front", {0, -1, 0}}, ClipSide{"back", {0, 1, 0}},
                            ClipSide{"left", {1, 0, 0}},   ClipSide{"right", {-1, 0, 0}},
                            ClipSide{"top", {0, 0, 1}},    ClipSide{"bottom", {0, 0, -1}}};

[[noreturn]] void refuse(std::string_view word) {
  throw Error(fmt::format("--clip: \"{}\" is not known; use camera, front, back, left, right, top or bottom, "
                          "and at= (mm from the middle toward it)",
                          word),
              Error::Kind::usage);
}

float millimetresIn(std::string_view word) {
  float value = 0;
  const std::string_view number = word.substr(word.find('=') + 1);
  const auto [end, failure] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (failure != std::errc() || end != number.data() + number.size() || !std::isfinite(value)) refuse(word);
  return value;
}

}  // namespace

ClipPlane parseClip(std::string_view text, const Camera& camera, const Box& box) {
  if (text.empty()) return {};
  glm::vec3 away = -camera.forward;
  float at = 0;
  while (!text.empty()) {
    const auto word = text.substr(0, text.find(','));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    const auto side = std::ranges::find(kSides, word, &ClipSide::name);
    if (side != kSides.end())
      away = side->direction;
    else if (word.starts_with("at="))
      at = millimetresIn(word);
    else if (word != "camera")
      refuse(word);
  }
  return clipPlaneThrough(box.centre() + at * away, -away);
}

ClipInUse::ClipInUse(gl::Program& program, const ClipPlane& plane) {
  program.set("clip", plane.equation());
  if (plane.normal != glm::vec3(0)) glEnable(GL_CLIP_DISTANCE0);
}

// Other programs write no distance.
ClipInUse::~ClipInUse() { glDisable(GL_CLIP_DISTANCE0); }

}  // namespace sonoskin
