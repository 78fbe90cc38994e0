#include "app/window/application.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>  // the codes of keys
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <memory>
#include <utility>

#include "app/panels/command_palette.h"
#include "app/panels/panels.h"
#include "app/panels/parameter_rows.h"
#include "app/texts/language_choice.h"
#include "app/texts/texts.h"
#include "app/widgets/theme.h"
#include "app/workspace/commands.h"
#include "app/workspace/document_view.h"
#include "app/workspace/session_actions.h"
#include "app/workspace/shown_layers.h"
#include "app/workspace/tour.h"
#include "app/workspace/view_history.h"
#include "core/base/error.h"
#include "core/base/error_text.h"
#include "core/base/log.h"
#include "core/base/task_pool.h"
#include "render/gl/context.h"

namespace sonoskin {
namespace {

constexpr double kIdleSeconds = 1.0, kTextCursorSeconds = 0.3;
// While something is made, the window looks for it often, which costs nothing, and draws the bar of its progress seldom: where
// OpenGL is drawn in software a frame takes the time of both.
constexpr double kLookSeconds = 0.008, kProgressSeconds = 0.2;

// What takes the keys once it is open, a bit each.
unsigned keyTakers(const Workspace& w) {
  unsigned bits = 0;
  for (const bool open :
       {w.files.purpose.has_value(), w.isAsked(), w.help.paletteShown, !w.help.wantedRow.empty()})
    bits = 2 * bits + open;
  return bits;
}

}  // namespace

Application::Application(const std::optional<std::filesystem::path>& file, const Parameters& parameters,
                         Around around)
    : apart_(std::move(around.apart)), workspace_(parameters) {
  TaskPool::instance().giveWay();
  workspace_.glInfo = gl::glInfo();
  workspace_.settings = std::move(around.settings);
  if (file) {
    openAny(workspace_, *file);
  } else {
    workspace_.session.openPhantom();
  }
  attempt([this] { askToRestore(); });
  offerTour(workspace_);
}

Application::~Application() {
  attempt([this] { writeSettings(settingsFile(), workspace_.settings); });
}

bool Application::attempt(const std::function<void()>& action) {
  try {
    action();
    return true;
  } catch (const Cancelled&) {
  } catch (const std::exception& error) {
    workspace_.toasts.add(trSentence(errorText(error)), true);
  }
  return false;
}

double Application::secondsToNext() const {
  double seconds = std::numeric_limits<double>::infinity();
  if (workspace_.session.activity().busy) seconds = kProgressSeconds;
  if (ImGui::GetIO().WantTextInput) seconds = std::min(seconds, kTextCursorSeconds);
  for (const double wanted : {viewsWant_, toastsWant_, playWants_, sheetWants_}) {
    if (wanted >= 0) seconds = std::min(seconds, wanted);
  }
  return seconds - sinceDrawn_.seconds();
}

double Application::waitSeconds() const {
  const double most = workspace_.session.activity().busy ? kLookSeconds : kIdleSeconds;
  return std::clamp(secondsToNext(), 0.0, most);
}

bool Application::takeIn() {
  bool arrived = false;
  attempt([&] { arrived = workspace_.session.poll(); });
  return arrived || log_.waiting();
}

void Application::keep() {
  attempt([this] { autosave_.look(workspace_); });
}

void Application::askToQuit() {
  attempt([this] { workspace_.confirmLoss(tr("Quitting"), [this] { workspace_.quit = true; }); });
}

// Keys are looked at when their frame has begun: whether a text field takes them is known only then.
void Application::takeInput(const FrameInput& input) {
  const std::optional<Event>& event = input.event;
  takeDropped(workspace_, input.dropped);
  workspace_.view.trail = event ? event->through : std::vector<glm::vec2>();
  if (!event || menuKeys_.take(*event, workspace_) || widgetKeys_.take(*event)) return;
  if (event->kind != Event::Kind::key || !event->down) return;
  const bool elsewhere = ImGui::GetIO().WantTextInput || workspace_.files.purpose || event->alt;
  const bool asked =
      workspace_.isAsked() && event->code != GLFW_KEY_ESCAPE;  // what is asked is answered first
  if (!elsewhere && !asked) runShortcut({event->code, event->control, event->shift}, workspace_);
}

void Application::updateDocument() {
  Session& session = workspace_.session;
  for (const Message& message : session.takeMessages())
    workspace_.toasts.add(trSentence(message.text), message.kind == Message::Kind::failure);
  for (const LogEntry& entry : log_.take()) {
    if (entry.level == LogLevel::warning)
      workspace_.toasts.warn(trSentence(entry.sentence));
    else if (noted_.insert(entry.sentence).second)
      workspace_.toasts.add(trSentence(entry.sentence), false);
  }
  const ViewState& view = workspace_.view;
  session.lookAt(isInSlices(workspace_, SliceLayer::classified) ? std::optional(view.cursor) : std::nullopt);
  if (auto choice = session.takeChoice()) workspace_.choice = std::move(choice);
  playWants_ = playOn(workspace_);
  const Scan& scan = session.scan();
  if (session.opened() != opened_) {
    opened_ = session.opened();
    noted_.clear();
    workspace_.play = {};
    workspace_.view.content = SpaceContent::volume;
    workspace_.typedSpacing = scan.volume->geometry.spacing;
    beginDocument(workspace_.view);
    resetView(workspace_.view, scan, session.beam());
  }
  takeInOpened(workspace_);
  if (shownPoints_.see({session.results().points})) {
    if (!workspace_.view.cameraMoved && session.hasScan()) workspace_.lookAtFace();
  }
  if (session.reconstructions() != reconstructions_) {
    reconstructions_ = session.reconstructions();
    workspace_.view.content = SpaceContent::mesh;
    if (!workspace_.view.cameraMoved) workspace_.lookAtFace();
  }
}

ui::KeySteering Application::beforeFrame() {
  useLanguage(languageOf(workspace_.settings.language));
  menuKeys_.beforeFrame();
  return widgetKeys_.forFrame();
}

Application::FrameWish Application::frame(const FrameInput& input) {
  frame_ = {};
  const unsigned before = keyTakers(workspace_);
  workspace_.screenScale = input.screenScale;
  workspace_.view.catchingUp = input.catchesUp;
  attempt([&] { takeInput(input); });
  attempt([this] { updateDocument(); });
  attempt([this] { drawInterface(); });
  noteViewEdits(workspace_, ImGui::IsAnyMouseDown() || ImGui::IsAnyItemActive());
  // An error may have left windows and groups open.
  ImGui::ErrorCheckEndFrameRecover(nullptr);
  // A menu that was asked for opens in the next frame, and is steered some later.
  return {(keyTakers(workspace_) & ~before) != 0 || widgetKeys_.steps(), workspace_.menuAsked ? 6 : 0};
}

void Application::afterFrame() {
  if (!workspace_.view.catchingUp) lookForGlErrors();
  workspace_.view.frameSeconds = frame_.seconds();
  sinceDrawn_ = {};
}

// Of several the newest is asked for; the others wait for the next start.
void Application::askToRestore() {
  std::vector<AutosaveSlot> left = readableLeft(stateFolder());
  if (left.empty()) return;
  for (std::size_t n = 1; n < left.size(); ++n) left[n].leave();
  const std::shared_ptr<AutosaveSlot> slot(new AutosaveSlot(std::move(left.front())), [](AutosaveSlot* kept) {
    kept->leave();  // unless it was answered
    delete kept;
  });
  const auto restore = [this, slot] {
    workspace_.session.openSession(autosave_.goOn(std::move(*slot)), true);
  };
  const auto discard = [slot] { const AutosaveSlot gone(std::move(*slot)); };
  workspace_.recovery = Workspace::Recovery{leftText(slot->file()), restore, discard};
}

// Each frame may have the same: one sentence is enough.
void Application::lookForGlErrors() {
  gl::pollErrors();
  if (glErrorTold_ || gl::glErrorCount() == 0) return;
  glErrorTold_ = true;
  log(LogLevel::warning, fmt::format("The graphics driver reports an error ({}), so that pictures may be "
                                     "wrong; a newer driver may help.",
                                     gl::lastGlError()));
}

void Application::drawInterface() {
  ui::drawMenuBar(workspace_);
  const ui::ToastPlace place = drawMain();
  ui::drawKeys(workspace_);
  ui::drawAbout(workspace_);
  ui::drawHistory(workspace_);
  ui::drawPalette(workspace_);
  ui::drawQuestion(workspace_);
  ui::drawPictureQuestion(workspace_);
  ui::drawColoursWindow(workspace_);
  sheetWants_ = sheet_.draw(workspace_, apart_);
  if (const auto choice = export_.draw(workspace_)) act(*choice);
  ui::drawVolumeChoice(workspace_);
  ui::drawRawQuestion(workspace_);
  ui::drawLostVolume(workspace_);
  ui::drawDropped(workspace_);
  ui::drawRecovery(workspace_);
  ui::drawLog(workspace_);
  toastsWant_ = ui::drawToasts(workspace_.toasts, place);
  tour_.draw(workspace_);
  if (const auto choice = ui::drawFileDialog(workspace_.files); choice && !export_.takes(*choice))
    act(*choice);
}

ui::ToastPlace Application::drawMain() {
  const ImGuiViewport& viewport = *ImGui::GetMainViewport();
  ImGui::SetNextWindowPos(viewport.WorkPos);
  ImGui::SetNextWindowSize(viewport.WorkSize);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::Begin("main", nullptr,
               ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoDecoration |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse |
                   ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar();
  const float status = ImGui::GetFrameHeight() + 6 * ui::unit();
  const float height = viewport.WorkSize.y - ImGui::GetCursorPosY() - status;
  const ui::ToastPlace place = ui::drawSidePanel(workspace_, {ui::sidePanelWidth(), height});
  ImGui::SameLine(0, 0);
  ImGui::BeginChild("views", {0, height});
  viewsWant_ = ui::drawFourUp(views_, workspace_);
  ui::drawViewBars(workspace_, views_.shown);
  ImGui::EndChild();
  ImGui::SetCursorPos({12 * ui::unit(), viewport.WorkSize.y - status + 3 * ui::unit()});
  ui::drawStatusBar(workspace_);
  ImGui::End();
  return place;
}

}  // namespace sonoskin
