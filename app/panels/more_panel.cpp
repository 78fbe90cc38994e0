#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/panels/panels.h"
#include "app/panels/parameter_rows.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"
#include "core/pipeline/face_use.h"

namespace sonoskin::ui {
namespace {

// The groups that have a panel of their own, or a place on one.
constexpr std::array<std::string_view, 10> kElsewhere{"raw",    "classification", "region", "reconstruction",
                                                      "global", "mesh",           "print",  "skin",
                                                      "light",  "landmarks"};

// The rows of a group under its heading; `below` is drawn after them.
template <class Options, class Below>
FieldsEdit drawGroup(const Group& group, Options& options, const Rows& rows, const Below& below) {
  const std::string title = sentence(group.name);
  FieldsEdit edit;
  if (!foldout(title.c_str(), sentence(group.help).c_str())) return edit;
  if (beginFields(title.c_str())) {
    edit = editFields(group.name, options, rows);
    endFields();
  }
  below();
  ImGui::Dummy({0, 4 * unit()});
  return edit;
}

// What was measured across the surface, and how far the points were moved onto it.
void drawEdge(const Results& results) {
  if (results.points && results.edge.width > 0)
    ImGui::TextDisabled("Edge: grey %.2f to %.2f in %.1f mm; points moved %.2f mm, onto the skin",
                        results.edge.dark, results.edge.bright, results.edge.width,
                        results.edge.shift + results.edge.depth);
}

// What was found, in a sentence.
void drawFace(const Workspace& workspace) {
  const std::string text =
      faceText(workspace.session.results().face.get(), workspace.session.parameters().face);
  if (text.empty()) return;
  ImGui::PushTextWrapPos(0);
  ImGui::TextDisabled("%s", sentence(text).c_str());
  ImGui::PopTextWrapPos();
}

// What has no effect for the parameters' sake, or the file's.
std::function<RowText(std::string_view)> scanUse(const Session& session, const Parameters& parameters,
                                                 std::string_view group) {
  return [use = useOf(parameters, group), given = session.givesSpacing(), group](std::string_view field) {
    if (group == "scan" && field == "spacing" && given)
      return RowText{.unused = "The file gives the spacing"};
    return use(field);
  };
}

}  // namespace

void drawMorePanel(Workspace& workspace) {
  section("More parameters");
  Parameters parameters = workspace.session.parameters();
  FieldsEdit edit;
  bool simulate = false;
  groups(
      [&](const Group& group, auto& options) {
        if (std::find(kElsewhere.begin(), kElsewhere.end(), group.name) != kElsewhere.end()) return;
        const Rows rows{{}, false, scanUse(workspace.session, parameters, group.name)};
        edit |= drawGroup(group, options, rows, [&] {
          if (group.name == "surface") drawEdge(workspace.session.results());
          if (group.name == "face") drawFace(workspace);
          if (group.name == "phantom") simulate = ImGui::Button("Simulate again", {-1, 0});
        });
      },
      parameters);
  applyEdit(workspace, parameters, edit);
  if (simulate) workspace.session.openPhantom();
}

}  // namespace sonoskin::ui
