#pragma once

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>  // the codes of keys

#include "app/window/interface.h"
#include "render/gl/context.h"
#include "render/gl/read_pixels.h"
#include "tests/app/player.h"

namespace sonoskin::test {

// InjectedPlayer: the application without a window and without a display: it draws into a framebuffer, and what a person does are
// events that nobody's mouse has sent.
class InjectedPlayer : public Player {
 public:
  explicit InjectedPlayer(const Parameters& parameters) : parameters_(parameters) { begin(); }

  Application& application() override { return *application_; }
  const ui::WidgetRects& rects() const override { return rects_; }

  void frames(int count) override {
    for (int n = 0; n < count || !queue_.empty(); ++n) frame();
  }
  void hand(const std::vector<Act>& acts) override {
    clock_ += 1;  // no two of them are a double click
    for (const Act& act : acts) inject(act);
    frames(4);
  }
  Image picture() override {
    frames(3);
    return gl::readImage(seen_);
  }
  void restart() override {
    application_.reset();
    interface_.reset();
    begin();
  }

  // atFrame: called after each.
  std::function<void()> atFrame;

 private:
  void begin();
  void frame();
  void inject(const Act& act);
  void injectKeys(const std::string& keys);
  void add(Event event) {
    event.time = clock_ += 0.01;
    queue_.add(std::move(event));
  }

  Parameters parameters_;
  std::shared_ptr<gl::Context> apart_ = gl::makeOffscreenContext();
  std::unique_ptr<gl::Context> context_ = gl::makeOffscreenContext();
  gl::Framebuffer seen_{{.size = {1500, 940}}};
  std::unique_ptr<Interface> interface_;
  std::unique_ptr<Application> application_;
  ui::WidgetRects rects_;
  EventQueue queue_;
  double clock_ = 0;
};

}  // namespace sonoskin::test
