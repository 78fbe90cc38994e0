#pragma once

#include <functional>
#include <initializer_list>
#include <string>

namespace sonoskin::ui {

// Answer: a button of a question; its name is for tests, and what it does for when it is pressed.
struct Answer {
  const char* text;
  const char* widget;
  std::function<void()> act;
};

// QuestionBox: a question in the middle of the window.
//   title  and "###" with what stays when the language changes
struct QuestionBox {
  const char* title;
  std::string text;
  std::function<void()> rest = {};  // drawn below the text
};

// drawQuestionBox: draws it while it is called. The answer closes it and acts, which has to end the question.
void drawQuestionBox(const QuestionBox& box, std::initializer_list<Answer> answers);

}  // namespace sonoskin::ui
