#include "app/widgets/message_log.h"

#include <gtest/gtest.h>

#include "app/workspace/commands.h"
#include "app/workspace/workspace.h"

namespace sonoskin::ui {
namespace {

// Toasts leave; what they said stays.
TEST(MessageLog, KeepsWhatToastsSay) {
  Toasts toasts;
  toasts.add("Saved.", false);
  toasts.warn("Doubtful.");
  toasts.add("Failed.", true);
  toasts.list.clear();
  ASSERT_EQ(toasts.log.entries.size(), 3u);
  EXPECT_EQ(toasts.log.entries[0].kind, MessageLog::Kind::note);
  EXPECT_EQ(toasts.log.entries[1].kind, MessageLog::Kind::warning);
  EXPECT_EQ(toasts.log.entries[2].kind, MessageLog::Kind::failure);
  EXPECT_EQ(toasts.log.entries[0].time.size(), 8u);
  const std::string text = toasts.log.text();
  EXPECT_NE(text.find(" note: Saved.\n"), std::string::npos) << text;
  EXPECT_NE(text.find(" warning: Doubtful.\n"), std::string::npos) << text;
  EXPECT_NE(text.find(" error: Failed.\n"), std::string::npos) << text;
}

TEST(MessageLog, CountsWhatWasNotSeenAndRepeatsNothing) {
  MessageLog log;
  log.add(MessageLog::Kind::note, "a");
  EXPECT_EQ(log.unseen, 0u);
  for (int n = 0; n < 5; ++n) log.add(MessageLog::Kind::warning, "b");
  EXPECT_EQ(log.entries.size(), 2u);
  EXPECT_EQ(log.unseen, 1u);
  log.open();
  log.add(MessageLog::Kind::warning, "c");
  EXPECT_EQ(log.unseen, 0u);
  for (std::size_t n = 0; n < 2 * MessageLog::kMost; ++n) log.add(MessageLog::Kind::note, std::to_string(n));
  EXPECT_EQ(log.entries.size(), MessageLog::kMost);
  EXPECT_EQ(log.entries.back().text, std::to_string(2 * MessageLog::kMost - 1));
}

TEST(MessageLog, ShowsAndCopiesTheKindsThatAreAskedFor) {
  MessageLog log;
  log.add(MessageLog::Kind::note, "Saved.");
  log.add(MessageLog::Kind::failure, "Failed.");
  EXPECT_EQ(log.count(MessageLog::Kind::failure), 1u);
  EXPECT_EQ(log.count(MessageLog::Kind::warning), 0u);
  log.levels[std::size_t(MessageLog::Kind::note)] = false;
  EXPECT_EQ(log.text().find("Saved"), std::string::npos);
  EXPECT_NE(log.text().find("Failed"), std::string::npos);
  log.clear();
  EXPECT_TRUE(log.text().empty());
  EXPECT_EQ(log.unseen, 0u);
}

TEST(MessageLog, OpensFromTheMenu) {
  Workspace workspace{Parameters()};
  command("view.messages").run(workspace);
  EXPECT_TRUE(workspace.toasts.log.shown);
  EXPECT_TRUE(command("view.messages").checked(workspace));
  command("view.messages").run(workspace);
  EXPECT_FALSE(workspace.toasts.log.shown);
}

}  // namespace
}  // namespace sonoskin::ui
