#include "app/panels/question_box.h"

#include <imgui.h>

#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {

namespace {

// Whose turn it is: a question has the window's middle until a frame goes without it.
struct Turn {
  ImGuiID question = 0;
  int frame = -1;  // in which it was asked last
};
Turn turn;

}  // namespace

bool askQuestion(const char* title) {
  const ImGuiID question = ImGui::GetID(title);
  const int frame = ImGui::GetFrameCount();
  const bool taken = turn.frame == frame || turn.frame + 1 == frame;
  if (taken && turn.question != question) return false;
  turn = {question, frame};
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  return true;
}

void drawQuestionBox(const QuestionBox& box, std::initializer_list<Answer> answers) {
  if (!askQuestion(box.title)) return;
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
  if (pressed) {
    ImGui::CloseCurrentPopup();
    turn = {};
  }
  ImGui::EndPopup();
  if (pressed) pressed->act();
}

}  // namespace sonoskin::ui
