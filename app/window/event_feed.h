#pragma once

#include <array>
#include <optional>

#include "app/window/event_queue.h"

struct ImGuiIO;

namespace sonoskin {

// EventFeed: tells Dear ImGui what happened, one event a frame. Its clock is that of the events: a double click is one
// however long frames take, and a key that was held for a moment does not repeat.
class EventFeed {
 public:
  // feed: call it before ImGui::NewFrame(), after what the backend does there.
  //   event  what this frame gets; none: nothing happened until `now`
  //   now    seconds of the events' clock
  void feed(const std::optional<Event>& event, double now, ImGuiIO& io);

 private:
  void note(const Event& event, ImGuiIO& io);

  glm::vec2 mouse_ = kNowhere;
  std::array<bool, 5> down_{};  // as many as ImGui knows
  double time_ = 0;
};

}  // namespace sonoskin
