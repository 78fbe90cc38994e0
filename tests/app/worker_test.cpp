#include "app/document/worker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/base/timer.h"

#include "app/document/history.h"
#include "core/base/error.h"

namespace sonoskin {
namespace {

void nap() { std::this_thread::sleep_for(std::chrono::milliseconds(2)); }

std::vector<std::string> wait(Worker& worker) {
  while (worker.status().busy) nap();
  return worker.poll();
}

// A task that only ends when it is cancelled.
Worker::Task endless(std::atomic<bool>& began, bool& delivered) {
  return {"endless",
          [&began](const Progress& progress) {
            began = true;
            for (;; nap()) progress.update(0.5);
          },
          [&delivered] { delivered = true; }};
}

TEST(Worker, DeliversInThePollingThread) {
  Worker worker;
  std::thread::id ran, delivered;
  worker.append({"one", [&](const Progress&) { ran = std::this_thread::get_id(); },
                 [&] { delivered = std::this_thread::get_id(); }});
  EXPECT_TRUE(worker.status().busy);
  EXPECT_TRUE(wait(worker).empty());
  EXPECT_NE(ran, std::this_thread::get_id());
  EXPECT_EQ(delivered, std::this_thread::get_id());
}

TEST(Worker, TellsFailures) {
  Worker worker;
  bool delivered = false;
  worker.append({"bad", [](const Progress&) { throw Error("the disk is full"); }, [&] { delivered = true; }});
  EXPECT_EQ(wait(worker), std::vector<std::string>{"The disk is full."});
  EXPECT_FALSE(delivered);
}

TEST(Worker, ReplaceCancelsWhatRuns) {
  Worker worker;
  std::atomic<bool> began{false};
  bool first = false, second = false;
  worker.replace(endless(began, first));
  while (!began) nap();
  worker.replace({"next", [](const Progress&) {}, [&] { second = true; }});
  EXPECT_TRUE(wait(worker).empty());
  EXPECT_FALSE(first);
  EXPECT_TRUE(second);
}

TEST(Worker, AppendKeepsTheOrder) {
  Worker worker;
  std::vector<int> order;
  for (int i = 0; i < 5; ++i)
    worker.append({"", [](const Progress&) { nap(); }, [&order, i] { order.push_back(i); }});
  wait(worker);
  EXPECT_EQ(order, (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(Worker, EndsWhileATaskRuns) {
  std::atomic<bool> began{false};
  bool delivered = false;
  {
    Worker worker;
    worker.append(endless(began, delivered));
    while (!began) nap();
  }
  EXPECT_FALSE(delivered);
}

TEST(History, UndoAndRedo) {
  History<int> history(1);
  EXPECT_FALSE(history.canUndo());
  history.push(2);
  history.push(3);
  history.undo();
  EXPECT_EQ(history.current(), 2);
  history.redo();
  EXPECT_EQ(history.current(), 3);
  history.undo();
  history.undo();
  history.undo();
  EXPECT_EQ(history.current(), 1);
  history.push(4);
  EXPECT_FALSE(history.canRedo()) << "a new step forgets what was undone";
  history.undo();
  EXPECT_EQ(history.current(), 1);
}

// Cancelled before the thread took it up: nothing is left to wait for.
TEST(Worker, RestsAfterWhatItHadNotBegunIsCancelled) {
  for (int i = 0; i < 200; ++i) {
    Worker worker;
    worker.append({"work", [](const Progress&) {}, {}});
    worker.cancel();
    const Timer timer;
    while (worker.status().busy && timer.seconds() < 10) std::this_thread::yield();
    ASSERT_FALSE(worker.status().busy);
  }
}

// What follows a task may fail too; that of the others is done all the same.
TEST(Worker, OneThatFailsAtTheEndLeavesTheOthers) {
  Worker worker;
  int ended = 0;
  for (int i = 0; i < 3; ++i) {
    worker.append({"work", [](const Progress&) {},
                   [&, i] {
                     if (i == 1) throw Error("There is no room for the second.");
                     ++ended;
                   }});
  }
  while (worker.status().busy) std::this_thread::yield();
  EXPECT_EQ(worker.poll(), std::vector<std::string>{"There is no room for the second."});
  EXPECT_EQ(ended, 2);
}

}  // namespace
}  // namespace sonoskin
