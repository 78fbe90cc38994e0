#include "app/window/event_queue.h"

#include <utility>

namespace sonoskin {

void EventQueue::add(Event event) {
  Event* last = events_.empty() ? nullptr : &events_.back();
  const bool same = last && last->kind == event.kind;
  if (same && event.kind == Event::Kind::position) {
    event.through = std::move(last->through);
    event.through.push_back(last->at);
    *last = std::move(event);
  } else if (same && event.kind == Event::Kind::wheel) {
    event.at += last->at;
    *last = std::move(event);
  } else if (same && event.kind == Event::Kind::text) {
    event.text.insert(0, last->text);
    *last = std::move(event);
  } else {
    events_.push_back(std::move(event));
  }
}

std::optional<Event> EventQueue::take() {
  if (resting_ > 0) {
    --resting_;
    return {};
  }
  if (events_.empty()) return {};
  Event first = std::move(events_.front());
  events_.pop_front();
  return first;
}

}  // namespace sonoskin
