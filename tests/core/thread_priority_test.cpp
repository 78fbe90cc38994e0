#include "core/base/thread_priority.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <thread>

namespace sonoskin {
namespace {

int niceness() { return getpriority(PRIO_PROCESS, id_t(gettid())); }

TEST(ThreadPriority, GivesWayAloneAndWithTheThreadsThatItMakes) {
  const int before = niceness();
  int own = -1, made = -1;
  std::thread([&] {
    giveWay();
    own = niceness();
    std::thread([&] { made = niceness(); }).join();
  }).join();
  EXPECT_GT(own, before);
  EXPECT_EQ(made, own);
  EXPECT_EQ(niceness(), before) << "the others keep theirs";
}

}  // namespace
}  // namespace sonoskin
