#pragma once

#include <gtest/gtest.h>
#include <imgui.h>

#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {

// ImGuiTest: an interface of a given size without a window and without OpenGL; `rects` tells where its widgets are.
class ImGuiTest : public testing::Test {
 protected:
  explicit ImGuiTest(const ImVec2& size) : size_(size) {}

  void SetUp() override {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = size_;
    io.DeltaTime = 1.0f / 60;
    io.UserData = &rects;
    loadFonts(1);
    applyTheme(1);
    unsigned char* pixels;
    int width, height;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  }
  void TearDown() override { ImGui::DestroyContext(); }

  // beginFrame: a new frame with one window that fills it; ImGui::End() and ImGui::Render() are the test's.
  void beginFrame() {
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(size_);
    ImGui::Begin("test", nullptr, ImGuiWindowFlags_NoDecoration);
  }

  WidgetRects rects;

 private:
  ImVec2 size_;
};

}  // namespace sonoskin::ui
