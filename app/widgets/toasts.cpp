#include "app/widgets/toasts.h"

#include <imgui.h>

#include <algorithm>

#include "app/texts/texts.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {
namespace {

constexpr double kNoteSeconds = 5, kWarningSeconds = 15, kFailureSeconds = 30;
constexpr std::size_t kMostAtOnce = 4;

double secondsOf(const Toasts::Toast& toast) {
  return toast.failure ? kFailureSeconds : toast.warning ? kWarningSeconds : kNoteSeconds;
}

// True when it was clicked away.
bool drawToast(const Toasts::Toast& toast, std::size_t number, ToastPlace& place) {
  ImGui::SetNextWindowPos({place.left, place.bottom}, ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowSizeConstraints({place.width, 0}, {place.width, FLT_MAX});
  const std::string id = "toast" + std::to_string(number);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6 * unit());
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
  ImGui::PushStyleColor(ImGuiCol_Border, toast.failure   ? colours().failure
                                         : toast.warning ? colours().warning
                                                         : colours().accent);
  ImGui::Begin(id.c_str(), nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoNav);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(toast.text.c_str());
  noteWidget(id);
  ImGui::PopTextWrapPos();
  if (toast.failure) ImGui::TextDisabled("%s", tr("Click for all messages"));
  const bool clicked = ImGui::IsWindowHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
  place.bottom -= ImGui::GetWindowHeight() + 8 * unit();
  ImGui::End();
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar(2);
  return clicked;
}

}  // namespace

void Toasts::add(const std::string& text, bool failure) { show({text, failure}); }

void Toasts::warn(const std::string& text) { show({text, false, true}); }

void Toasts::show(Toast added) {
  using Kind = MessageLog::Kind;
  log.add(added.failure ? Kind::failure : added.warning ? Kind::warning : Kind::note, added.text);
  // The same sentence again and again (a slider in motion) is one message.
  std::erase_if(list, [&](const Toast& toast) { return toast.text == added.text; });
  list.push_back(std::move(added));
  if (list.size() > kMostAtOnce) list.erase(list.begin());
}

double drawToasts(Toasts& toasts, ToastPlace place) {
  double next = -1;
  const double now = ImGui::GetTime();
  std::size_t number = 0;
  for (auto toast = toasts.list.begin(); toast != toasts.list.end(); ++number) {
    if (toast->until == 0) toast->until = now + secondsOf(*toast);
    const bool clicked = drawToast(*toast, number, place);
    const double left = toast->until - now;
    if (clicked) toasts.log.open();
    if (clicked || left <= 0) {
      toast = toasts.list.erase(toast);
      continue;
    }
    next = next < 0 ? left : std::min(next, left);
    ++toast;
  }
  return next;
}

}  // namespace sonoskin::ui
