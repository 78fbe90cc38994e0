#include "app/views/pane.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <exception>

#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "core/base/error_text.h"

namespace sonoskin::ui {
namespace {

constexpr ImGuiWindowFlags kPaneFlags = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse |
                                        ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav;

glm::vec2 vec(ImVec2 v) { return {v.x, v.y}; }

// The largest 1, 2 or 5 times a power of ten that is not larger than `most`.
double roundNumberBelow(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= most) return factor * power;
  }
  return power;
}

}  // namespace

PaneInput beginPane(const char* id, ImVec2 corner, ImVec2 size) {
  ImGui::SetCursorScreenPos(corner);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::BeginChild(id, size, false, kPaneFlags);
  ImGui::PopStyleVar();
  ImGui::InvisibleButton("mouse", size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  noteWidget(std::string("pane.") + id);
  const ImGuiIO& io = ImGui::GetIO();
  PaneInput pane;
  pane.corner = vec(corner);
  pane.size = vec(size);
  pane.mouse = vec(io.MousePos) - pane.corner;
  pane.moved = vec(io.MouseDelta);
  pane.hovered = ImGui::IsItemHovered();
  pane.control = io.KeyCtrl;
  pane.shift = io.KeyShift;
  if (pane.hovered) pane.wheel = io.MouseWheel;
  pane.doubleClicked = pane.hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  if (ImGui::IsItemActive()) {
    for (int button = 2; button >= 0; --button) {
      if (ImGui::IsMouseDown(button)) pane.button = button;
    }
    pane.pressed = ImGui::IsItemActivated();
  }
  return pane;
}

void endPane() { ImGui::EndChild(); }

std::string failureOf(const std::function<void()>& draw) try {
  draw();
  return {};
} catch (const std::exception& error) {
  return errorText(error);
}

void showTexture(const PaneInput& pane, const gl::Framebuffer& framebuffer) {
  const ImVec2 first(pane.corner.x, pane.corner.y),
      last(pane.corner.x + pane.size.x, pane.corner.y + pane.size.y);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (!framebuffer) return list.AddRectFilled(first, last, IM_COL32(6, 7, 9, 255));
  const auto texture = reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(framebuffer.colour().name()));
  // The picture's first row is the lowest one.
  list.AddImage(texture, first, last, {0, 1}, {1, 0});
}

void shadedText(ImVec2 p, const ImVec4& colour, const std::string& text) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImFont* font = smallFont();
  const float d = unit();
  const auto add = [&](float x, float y, ImU32 c) {
    list.AddText(font, font->FontSize, {p.x + x, p.y + y}, c, text.c_str());
  };
  add(d, d, IM_COL32(0, 0, 0, 200));
  add(0, d, IM_COL32(0, 0, 0, 120));
  add(0, 0, ImGui::GetColorU32(colour));
}

void shadedLines(const PaneInput& pane, std::initializer_list<std::string> lines) {
  ImVec2 at{pane.corner.x + 12 * unit(), pane.corner.y + 36 * unit()};
  for (const std::string& line : lines) {
    shadedText(at, kText, line);
    at.y += 1.15f * smallFont()->FontSize;
  }
}

void paneTitle(const PaneInput& pane, const char* title, const ImVec4& colour, const std::string& text) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float u = unit();
  list.AddRectFilled({pane.corner.x, pane.corner.y}, {pane.corner.x + pane.size.x, pane.corner.y + 2 * u},
                     ImGui::GetColorU32(colour));
  ImFont* font = headingFont();
  const ImVec2 p{pane.corner.x + 10 * u, pane.corner.y + 9 * u};
  const float width = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, title).x;
  const float rest =
      text.empty() ? 0
                   : smallFont()->CalcTextSizeA(smallFont()->FontSize, FLT_MAX, 0, text.c_str()).x + 10 * u;
  // Lines of the crop box may run behind it.
  list.AddRectFilled({p.x - 4 * u, p.y - 2 * u}, {p.x + width + rest + 4 * u, p.y + font->FontSize + 2 * u},
                     IM_COL32(6, 7, 9, 170), 3 * u);
  list.AddText(font, font->FontSize, {p.x + u, p.y + u}, IM_COL32(0, 0, 0, 200), title);
  list.AddText(font, font->FontSize, p, ImGui::GetColorU32(colour), title);
  shadedText({p.x + width + 10 * u, p.y + u}, kText, text);
}

void paneText(const PaneInput& pane, const std::string& text) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  ImGui::GetWindowDrawList()->AddText(
      {pane.corner.x + 0.5f * (pane.size.x - size.x), pane.corner.y + 0.5f * (pane.size.y - size.y)},
      ImGui::GetColorU32(kFaintText), text.c_str());
}

void scaleBar(const PaneInput& pane, double pixelsPerMm) {
  const float u = unit();
  const double mm = roundNumberBelow(0.28 * double(pane.size.x) / pixelsPerMm);
  const float length = static_cast<float>(mm * pixelsPerMm);
  const ImVec2 right{pane.corner.x + pane.size.x - 14 * u, pane.corner.y + pane.size.y - 14 * u};
  const ImVec2 left{right.x - length, right.y};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto line = [&](ImVec2 from, ImVec2 to) {
    list.AddLine({from.x + u, from.y + u}, {to.x + u, to.y + u}, IM_COL32(0, 0, 0, 180), u);
    list.AddLine(from, to, ImGui::GetColorU32(kText), u);
  };
  line(left, right);
  line({left.x, left.y - 4 * u}, left);
  line({right.x, right.y - 4 * u}, right);
  const std::string text = fmt::format("{:g} mm", mm);
  const float width = smallFont()->CalcTextSizeA(smallFont()->FontSize, FLT_MAX, 0, text.c_str()).x;
  shadedText({right.x - 0.5f * (length + width), right.y - 19 * u}, kText, text);
}

}  // namespace sonoskin::ui
