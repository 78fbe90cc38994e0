#include "app/window/window_loop.h"

#include <utility>

namespace sonoskin {

WindowLoop::WindowLoop(const std::optional<std::filesystem::path>& file, const Parameters& parameters)
    : settings_(readSettings(settingsFile())),
      window_("Sonoskin", {settings_.width, settings_.height}, {settings_.appearance, settings_.scale}),
      application_(file, parameters, {settings_, [this] {
                                        if (!background_) background_.emplace();
                                        return background_->share();
                                      }}) {}

WindowLoop::~WindowLoop() {
  const glm::vec2 size = glm::vec2(window_.size()) / window_.scale();
  Settings& settings = application_.workspace().settings;
  settings.width = static_cast<int>(size.x);
  settings.height = static_cast<int>(size.y);
}

bool WindowLoop::frame() {
  const bool event = window_.waitForFrame(application_.waitSeconds());
  const bool due = application_.secondsToNext() <= 0;
  const bool arrived = application_.takeIn();
  if (arrived) window_.requestFrames(application_.workspace().session.activity().busy ? 1 : 3);
  if (event || arrived || due) draw();
  application_.keep();
  if (window_.closeRequested()) answerClosing();
  return application_.goesOn();
}

void WindowLoop::draw() {
  std::optional<Event> event;
  const bool begun = application_.attempt([&] {
    if (atFrame && !window_.eventsWait()) atFrame();
    const Settings& settings = application_.workspace().settings;
    window_.setLook({settings.appearance, settings.scale});
    event = window_.beginFrame(application_.beforeFrame());
  });
  if (!begun) return;
  const Application::FrameWish wish = application_.frame(
      {event, window_.takeDroppedFiles(), window_.eventsWait(), double(window_.screenScale())});
  if (wish.settle) window_.settle();
  if (wish.frames > 0) window_.requestFrames(wish.frames);
  showModified();
  application_.attempt([this] { window_.endFrame(); });
  application_.afterFrame();
}

void WindowLoop::showModified() {
  const bool modified = application_.workspace().isModified();
  if (std::exchange(titleModified_, modified) == modified) return;
  window_.setTitle(modified ? "● Sonoskin" : "Sonoskin");
}

void WindowLoop::answerClosing() {
  window_.keepOpen();  // until the question is answered, where there is one
  window_.requestFrames();
  application_.askToQuit();
}

}  // namespace sonoskin
