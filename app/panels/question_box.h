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

// askQuestion: opens a question's box, called in each frame in which it is asked. Of several that are asked at once the first
// has its turn, and the others wait until it is answered.
//   output  whether it is this one's turn
bool askQuestion(const char* title);

// drawQuestionBox: draws it while it is called, in its turn. The answer closes it and acts, which has to end the question.
void drawQuestionBox(const QuestionBox& box, std::initializer_list<Answer> answers);

}  // namespace sonoskin::ui
