#include "app/panels/question_box.h"

#include <imgui.h>

#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {

void drawQuestionBox(const QuestionBox& box, std::initializer_list<Answer> answers) {
  if (!ImGui::IsPopupOpen(box.title)) ImGui::OpenPopup(box.title);
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
  if (!ImGui::BeginPopupModal(box.title, nullptr,
                              ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove))
    return;
  const ImVec2 size{132 * unit(), 0};
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  ImGui::PushTextWrapPos(std::max(400 * unit(), float(answers.size()) * (size.x + gap)));
  ImGui::TextUnformatted(box.text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
  if (box.rest) box.rest();
  const Answer* pressed = nullptr;
  for (const Answer& answer : answers) {
    if (&answer != answers.begin()) ImGui::SameLine();
    if (ImGui::Button(answer.text, size)) pressed = &answer;
    noteWidget(answer.widget);
  }
  if (pressed) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  if (pressed) pressed->act();
}

}  // namespace sonoskin::ui
