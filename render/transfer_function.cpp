#include "render/transfer_function.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace sonoskin {

glm::vec4 TransferFunction::at(float value) const {
  assert(!points.empty());
  const auto above = std::upper_bound(points.begin(), points.end(), value,
                                      [](float v, const Point& p) { return v < p.value; });
  const auto rgba = [](const Point& p) { return glm::vec4(p.colour, p.opacity); };
  if (above == points.begin()) return rgba(points.front());
  if (above == points.end()) return rgba(points.back());
  const Point& low = *(above - 1);
  return glm::mix(rgba(low), rgba(*above), (value - low.value) / (above->value - low.value));
}

float TransferFunction::threshold() const {
  if (points.empty() || points.front().opacity > 0) return 0;
  for (const Point* p = &points.front(); p != &points.back(); ++p)
    if ((p + 1)->opacity > 0) return p->value;
  return 1;
}

TransferFunction amberTransfer(float iso) {
  return {{{0.55f * iso, {0.20f, 0.035f, 0.010f}, 0},
           {iso, {0.55f, 0.20f, 0.075f}, 0.13f},
           {std::min(1.45f * iso, 0.5f + 0.5f * iso), {0.85f, 0.45f, 0.20f}, 0.42f},
           {1, {1.0f, 0.86f, 0.62f}, 0.65f}}};
}

TransferFunction greyTransfer(float iso) {
  TransferFunction transfer = amberTransfer(iso);
  for (auto& point : transfer.points) point.colour = glm::vec3(0.15f + 0.8f * point.value);
  return transfer;
}

gl::Texture makeTransferTexture(const TransferFunction& transfer, float layers) {
  constexpr int kTexels = 1024;
  std::vector<glm::vec4> texels;
  for (int i = 0; i < kTexels; ++i) {
    glm::vec4 look = transfer.at(float(i) / float(kTexels - 1));
    look.a = 1 - std::pow(1 - look.a, layers);
    texels.push_back(look);
  }
  gl::Texture texture(
      {.size = {kTexels, 1, 0}, .format = gl::Format::rgba32f, .filter = gl::Filter::nearest});
  texture.upload(texels.data());
  return texture;
}

}  // namespace sonoskin
