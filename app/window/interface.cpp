#include "app/window/interface.h"

#include <imgui.h>
#include <imgui_impl_opengl3.h>

#include "app/widgets/theme.h"

namespace sonoskin {

float scaleOfScreen(float told, int pixelsAcross) {
  constexpr int kDenseScreen = 3200;  // from which texts of a scale of 1 are too small to read
  return told == 1 && pixelsAcross >= kDenseScreen ? 2 : told;
}

Interface::Interface() {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // the layout is computed, there is nothing to remember
  ImGui_ImplOpenGL3_Init("#version 450");
}

Interface::~Interface() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

bool Interface::dress(const WindowLook& look) {
  if (drawn_ == look) return false;
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ui::loadFonts(float(look.scale));
  ui::applyTheme(float(look.scale), look.appearance);
  ImGui_ImplOpenGL3_CreateFontsTexture();
  drawn_ = look;  // tried again in the next frame where one of these failed
  return true;
}

void Interface::beginFrame(const std::optional<Event>& event, double now, const ui::KeySteering& steering) {
  ImGui_ImplOpenGL3_NewFrame();
  feed_.feed(event, now, ImGui::GetIO());
  ui::steerByKeys(steering);
  ImGui::NewFrame();
}

void Interface::endFrame(bool seen) {
  ui::stepOn();
  if (!seen) return ImGui::EndFrame();
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace sonoskin
