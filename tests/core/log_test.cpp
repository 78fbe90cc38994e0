#include "core/base/log.h"

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

namespace sonoskin {
namespace {

TEST(Log, GoesToTheListenerElseToStandardError) {
  std::vector<std::string> heard;
  setLogListener([&](LogLevel level, const std::string& sentence) {
    heard.push_back((level == LogLevel::warning ? "W " : "I ") + sentence);
  });
  log(LogLevel::info, "one");
  log(LogLevel::warning, "two");
  setLogListener({});
  testing::internal::CaptureStderr();
  log(LogLevel::warning, "three");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "sonoskin: warning: three\n");
  EXPECT_EQ(heard, (std::vector<std::string>{"I one", "W two"}));
}

TEST(Log, RecordsHearWhatTheListenerHearsAndFromAnyThread) {
  setLogListener([](LogLevel, const std::string&) {});
  LogRecord all, taken;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([t] {
      for (int n = 0; n < 100; ++n) log(LogLevel::warning, "of thread " + std::to_string(t));
    });
  for (std::thread& thread : threads) thread.join();
  log(LogLevel::info, "a note");
  EXPECT_EQ(all.sentences(LogLevel::warning).size(), 4u) << "each once";
  EXPECT_EQ(all.sentences(LogLevel::info), std::vector<std::string>{"a note"});
  EXPECT_EQ(taken.take().size(), 401u);
  EXPECT_FALSE(taken.waiting());
  EXPECT_TRUE(taken.sentences(LogLevel::warning).empty());
  {
    const LogRecord late;
    EXPECT_FALSE(late.waiting());
  }
  log(LogLevel::info, "after a record ended");
  setLogListener({});
  EXPECT_EQ(taken.take().size(), 1u);
}

// Sentences may hold words out of files.
TEST(Log, HoldsNothingThatATerminalObeys) {
  LogRecord record;
  testing::internal::CaptureStderr();
  log(LogLevel::info, "a\033[2Jb\nc\x7f");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "sonoskin: note: a?[2Jb?c?\n");
  EXPECT_EQ(record.take().at(0).sentence, "a?[2Jb?c?");
}

}  // namespace
}  // namespace sonoskin
