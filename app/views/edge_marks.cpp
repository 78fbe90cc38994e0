#include "app/views/edge_marks.h"

#include <cfloat>

#include "app/texts/texts.h"
#include "app/widgets/theme.h"

namespace sonoskin::ui {
namespace {

constexpr float kBelowTitle = 35;  // the first line of a view is its title's, and that of its bar

// Letters stand out, as those who read pictures look for them first.
void drawLetters(const PaneInput& pane, const std::string& text, const glm::vec2& side) {
  const float u = unit();
  ImFont* font = headingFont();
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str());
  const glm::vec2 half(0.5f * size.x, 0.5f * size.y);
  const glm::vec2 reach = 0.5f * pane.size - half - glm::vec2(7, 7) * u;
  glm::vec2 place = pane.corner + 0.5f * pane.size + side * reach - half;
  if (side.y < 0) place.y = pane.corner.y + kBelowTitle * u;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  // The cross-hair and lines of the crop box may run behind it.
  list.AddRectFilled({place.x - 3 * u, place.y - u}, {place.x + size.x + 3 * u, place.y + size.y + u},
                     IM_COL32(6, 7, 9, 190), 3 * u);
  list.AddText(font, font->FontSize, {place.x + u, place.y + u}, IM_COL32(0, 0, 0, 220), text.c_str());
  list.AddText(font, font->FontSize, {place.x, place.y}, ImGui::GetColorU32(kAccent), text.c_str());
}

}  // namespace

void drawEdges(const PaneInput& pane, const ViewFrame& frame, const SliceFrame& slice) {
  const glm::dvec3 right = glm::normalize(slice.right), down = glm::normalize(slice.down);
  const auto draw = [&](const glm::dvec3& direction, const glm::vec2& side) {
    const std::string text = edgeText(frame, direction);
    if (!text.empty()) drawLetters(pane, frame.isPatient ? text : tr(text.c_str()), side);
  };
  draw(-right, {-1, 0});
  draw(right, {1, 0});
  draw(-down, {0, -1});
  draw(down, {0, 1});
}

}  // namespace sonoskin::ui
