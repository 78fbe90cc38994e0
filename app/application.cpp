#include "app/application.h"

#include <imgui.h>

#include "app/theme.h"

namespace sonoskin {

Application::Application(const std::optional<std::filesystem::path>& file, const Parameters& parameters)
    : window_("Sonoskin", {1500, 940}), file_(file), parameters_(parameters) {}

bool Application::frame() {
  if (window_.waitForFrame(0.5)) {
    window_.beginFrame();
    draw();
    window_.endFrame();
  }
  return !window_.closeRequested();
}

void Application::draw() {
  const ImGuiViewport& viewport = *ImGui::GetMainViewport();
  ImGui::SetNextWindowPos(viewport.WorkPos);
  ImGui::SetNextWindowSize(viewport.WorkSize);
  ImGui::Begin("main", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::TextUnformatted(file_ ? file_->c_str() : "phantom");
  ImGui::End();
}

}  // namespace sonoskin
