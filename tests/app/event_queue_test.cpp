#include "app/window/event_queue.h"

#include <gtest/gtest.h>

namespace sonoskin {
namespace {

using Kind = Event::Kind;

Event moveTo(float x, double time = 0) { return {.kind = Kind::position, .time = time, .at = {x, 0}}; }
Event button(bool down, int code = 0) { return {.kind = Kind::button, .code = code, .down = down}; }
Event key(int code, bool down) { return {.kind = Kind::key, .code = code, .down = down}; }
Event wheel(float notches) { return {.kind = Kind::wheel, .at = {0, notches}}; }
Event text(char32_t c) { return {.kind = Kind::text, .text = {c}}; }

TEST(EventQueue, PositionsAreOneFrameUntilAButtonMoves) {
  EventQueue queue;
  for (const Event& event : {moveTo(1), moveTo(2), button(true), moveTo(3), moveTo(4, 7), button(false)})
    queue.add(event);
  EXPECT_EQ(queue.take()->at.x, 2);
  EXPECT_TRUE(queue.take()->down);
  const auto moved = queue.take();
  EXPECT_EQ(moved->at.x, 4) << "where it was let go";
  ASSERT_EQ(moved->through.size(), 1u) << "what is drawn by hand needs its way";
  EXPECT_EQ(moved->through[0].x, 3);
  EXPECT_EQ(moved->time, 7);
  EXPECT_FALSE(queue.empty());
  EXPECT_FALSE(queue.take()->down);
  EXPECT_TRUE(queue.empty());
  EXPECT_FALSE(queue.take());
}

TEST(EventQueue, EveryTransitionHasItsFrame) {
  EventQueue queue;
  const Event all[] = {button(true),    button(false), button(true),
                       button(true, 1), key(65, true), key(65, false)};
  for (const Event& event : all) queue.add(event);
  for (const Event& event : all) {
    const auto taken = queue.take();
    ASSERT_TRUE(taken);
    EXPECT_EQ(taken->kind, event.kind);
    EXPECT_EQ(taken->code, event.code);
    EXPECT_EQ(taken->down, event.down);
  }
}

TEST(EventQueue, TurnsAddUpAndCharactersKeepTheirOrder) {
  EventQueue queue;
  for (const Event& event : {wheel(1), wheel(2), text(U'a'), text(U'é'), key(259, true), text(U'b')})
    queue.add(event);
  EXPECT_EQ(queue.take()->at.y, 3);
  EXPECT_EQ(queue.take()->text, U"aé");
  EXPECT_EQ(queue.take()->code, 259);
  EXPECT_EQ(queue.take()->text, U"b");
}

TEST(EventQueue, RestsForWhatHasOpened) {
  EventQueue queue;
  queue.add(key(257, true));
  queue.rest(2);
  EXPECT_FALSE(queue.take());
  EXPECT_FALSE(queue.take());
  EXPECT_EQ(queue.take()->code, 257);
}

}  // namespace
}  // namespace sonoskin
