#include "app/widgets/transfer_points.h"

#include <algorithm>

namespace sonoskin::ui {

int addPoint(TransferFunction& transfer, float value) {
  const glm::vec4 look = transfer.at(value);
  const auto before = std::ranges::upper_bound(transfer.points, value, {}, &TransferFunction::Point::value);
  const auto made = transfer.points.insert(before, {value, glm::vec3(look), look.a});
  return int(made - transfer.points.begin());
}

void movePoint(TransferFunction& transfer, int point, float value, float opacity) {
  auto& points = transfer.points;
  const auto p = std::size_t(point);
  const float least = p > 0 ? points[p - 1].value : 0, most = p + 1 < points.size() ? points[p + 1].value : 1;
  points[p].value = std::clamp(value, least, most);
  points[p].opacity = std::clamp(opacity, 0.0f, 1.0f);
}

bool removePoint(TransferFunction& transfer, int point) {
  if (transfer.points.size() <= 2 || point < 0 || point >= int(transfer.points.size())) return false;
  transfer.points.erase(transfer.points.begin() + point);
  return true;
}

}  // namespace sonoskin::ui
