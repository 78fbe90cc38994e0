#include "core/base/log.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace sonoskin
