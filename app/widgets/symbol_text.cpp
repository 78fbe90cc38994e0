#include "app/widgets/symbol_text.h"

#include <imgui.h>
#include <imgui_internal.h>

#include "app/widgets/theme.h"

namespace sonoskin::ui {
namespace {

constexpr float kIndexSize = 0.76f;  // of the text's

struct Parts {
  std::string base, index;
};

Parts partsOf(const std::string& symbol) {
  const std::size_t at = symbol.find('_');
  return at == std::string::npos ? Parts{symbol, {}} : Parts{symbol.substr(0, at), symbol.substr(at + 1)};
}

float indexWidth(const std::string& index) {
  return ImGui::GetFont()->CalcTextSizeA(kIndexSize * ImGui::GetFontSize(), FLT_MAX, 0, index.c_str()).x;
}

}  // namespace

float symbolWidth(const std::string& symbol) {
  const Parts parts = partsOf(symbol);
  return symbol.empty() ? 0 : ImGui::CalcTextSize(parts.base.c_str()).x + indexWidth(parts.index);
}

void drawSymbol(const std::string& symbol) {
  const Parts parts = partsOf(symbol);
  const float size = ImGui::GetFontSize(), width = ImGui::CalcTextSize(parts.base.c_str()).x;
  const float lower = ImGui::GetCurrentWindow()->DC.CurrLineTextBaseOffset;  // as the line's text lies
  ImGui::Dummy({symbolWidth(symbol), size});
  const ImVec2 at{ImGui::GetItemRectMin().x, ImGui::GetItemRectMin().y + lower};
  const ImU32 colour = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText(at, colour, parts.base.c_str());
  if (parts.index.empty()) return;
  list.AddText(ImGui::GetFont(), kIndexSize * size, {at.x + width, at.y + 0.36f * size}, colour,
               parts.index.c_str());
}

}  // namespace sonoskin::ui
