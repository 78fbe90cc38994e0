#include <fmt/format.h>
#include <imgui.h>

#include <utility>

#include "app/panels/panels.h"
#include "app/panels/question_box.h"
#include "app/texts/texts.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"
#include "app/workspace/session_actions.h"

namespace sonoskin::ui {
namespace {

// The file that was pressed, if any.
const std::filesystem::path* drawFiles(const std::vector<std::filesystem::path>& files) {
  const std::filesystem::path* pressed = nullptr;
  const float rows = float(std::min<std::size_t>(files.size(), 12));
  ImGui::BeginChild("files", {400 * unit(), (rows + 0.5f) * ImGui::GetFrameHeightWithSpacing()});
  for (std::size_t n = 0; n < files.size(); ++n) {
    ImGui::PushID(int(n));
    if (ImGui::Selectable(files[n].filename().c_str())) pressed = &files[n];
    ImGui::PopID();
    noteWidget(fmt::format("dropped.{}", n + 1));
  }
  ImGui::EndChild();
  return pressed;
}

}  // namespace

void drawQuestion(Workspace& w) {
  if (!w.question || w.files.purpose) return;
  const std::string title = std::string(tr("Unsaved work")) + "###unsaved";
  const std::string text =
      trf("{} loses what is not saved: changes of parameters and marks, what was erased, or the "
          "surface. A session keeps all of it.",
          w.question->what);
  const auto take = [&w] { return std::exchange(w.question, std::nullopt)->action; };
  drawQuestionBox({title.c_str(), text},
                  {{tr("Save session"), "question.save", [&] { saveSession(w, take()); }},
                   {tr("Discard"), "question.discard", [&] { take()(); }},
                   {tr("Cancel"), "question.back", [&] { w.question.reset(); }}});
}

void drawLostVolume(Workspace& w) {
  if (!w.lostVolume || w.files.purpose) return;
  const std::string title = std::string(tr("The session's volume")) + "###lost";
  const auto choose = [&w] { w.files.ask(FilePurpose::findVolume, w.settings.folder, ""); };
  drawQuestionBox({title.c_str(), trf("{}. Choose the file, please.", trSentence(w.lostVolume->why))},
                  {{tr("Choose..."), "lost.choose", choose},
                   {tr("Cancel"), "lost.cancel", [&w] { w.lostVolume.reset(); }}});
}

void drawDropped(Workspace& w) {
  if (w.dropped.empty() || w.files.purpose) return;
  const std::string title = std::string(tr("Several files")) + "###dropped";
  const std::filesystem::path* pressed = nullptr;
  const auto open = [&w](const std::filesystem::path& file) {
    const std::filesystem::path chosen = file;
    w.dropped.clear();
    openAny(w, chosen);
  };
  drawQuestionBox({title.c_str(), tr("The window opens one file at a time; which one?"),
                   [&] { pressed = drawFiles(w.dropped); }},
                  {{tr("The first"), "dropped.first", [&] { open(w.dropped.front()); }},
                   {tr("Cancel"), "dropped.cancel", [&w] { w.dropped.clear(); }}});
  if (pressed) open(*pressed);
}

void drawRecovery(Workspace& w) {
  if (!w.recovery || w.files.purpose) return;
  const std::string title = std::string(tr("Restore")) + "###recovery";
  const std::string text = trf("Sonoskin ended unexpectedly. Restore what was open ({})?", w.recovery->told);
  const auto take = [&w] { return *std::exchange(w.recovery, std::nullopt); };
  drawQuestionBox({title.c_str(), text}, {{tr("Restore"), "recovery.restore", [&] { take().restore(); }},
                                          {tr("Discard"), "recovery.discard", [&] { take().discard(); }},
                                          {tr("Ask later"), "recovery.later", [&] { w.recovery.reset(); }}});
}

}  // namespace sonoskin::ui
