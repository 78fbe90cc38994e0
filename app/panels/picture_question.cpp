#include <imgui.h>

#include <algorithm>

#include "app/batch/turntable_files.h"
#include "app/panels/panels.h"
#include "app/panels/picture_format_rows.h"
#include "app/panels/question_box.h"
#include "app/texts/texts.h"
#include "app/widgets/fields_ui.h"
#include "app/widgets/layout.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {
namespace {

constexpr int kLeastPixels = 16, kMostPixels = 8192;

void editNumber(const char* name, int& value, int least, int most) {
  ImGui::SetNextItemWidth(-1);
  ImGui::InputInt(name, &value, 0, 0);
  noteWidget(std::string("picture.") + (name + 2));
  if (ImGui::IsItemDeactivatedAfterEdit()) value = std::clamp(value, least, most);
}

void drawSize(PictureFormat& format) {
  beginRow(tr("Width"));
  editNumber("##width", format.size[0], kLeastPixels, kMostPixels);
  beginRow(tr("Height"));
  editNumber("##height", format.size[1], kLeastPixels, kMostPixels);
}

void chooseUsual(PictureFormat& format) {
  struct Usual {
    const char* name;
    std::array<int, 2> size;
  };
  constexpr std::array kUsual{Usual{"1280 x 960", {1280, 960}}, Usual{"1920 x 1080", {1920, 1080}},
                              Usual{"3840 x 2160", {3840, 2160}}};
  for (const Usual& usual : kUsual) {
    if (&usual != kUsual.data()) ImGui::SameLine();
    if (ImGui::SmallButton(usual.name)) format.size = usual.size;
    noteWidget(std::string("picture.") + usual.name);
  }
}

}  // namespace

void drawPictureFormat(PictureFormat& format, bool turntable) {
  if (beginFields("picture format")) {
    drawSize(format);
    if (turntable) {
      beginRow(tr("Pictures"));
      editNumber("##views", format.views, 2, kMostViews);
    }
    endFields();
  }
  chooseUsual(format);
  ImGui::Checkbox(tr("Transparent background"), &format.transparent);
  noteWidget("picture.transparent");
  if (turntable) sentenceText(tr("One PNG each, and a film where ffmpeg is installed."));
}

namespace {

void ask(Workspace& w, bool turntable) {
  if (turntable)
    w.files.ask(FilePurpose::saveTurntable, w.settings.folder, "turntable.png");
  else
    w.files.ask(FilePurpose::savePicture, w.settings.folder, w.session.proposedName(".png"));
}

}  // namespace

void drawPictureQuestion(Workspace& workspace) {
  if (!workspace.pictureRequest) return;
  const bool turntable = workspace.pictureRequest->turntable;
  const std::string title = std::string(turntable ? tr("Save turntable") : tr("Save picture")) + "###picture";
  const auto end = [&workspace] { workspace.pictureRequest.reset(); };
  drawQuestionBox({title.c_str(), tr("The 3D view as it is, without its marks."),
                   [&] { drawPictureFormat(workspace.pictureFormat, turntable); }},
                  {{tr("Cancel"), "picture.cancel", end}, {tr("Save..."), "picture.save", [&] {
                                                             end();
                                                             ask(workspace, turntable);
                                                           }}});
}

}  // namespace sonoskin::ui
