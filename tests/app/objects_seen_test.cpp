#include "app/workspace/objects_seen.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace sonoskin {
namespace {

TEST(ObjectsSeen, TellsOthersFromTheSame) {
  ObjectsSeen<2> seen;
  EXPECT_FALSE(seen.see({})) << "there were none";
  const auto a = std::make_shared<int>(1), b = std::make_shared<int>(1);
  EXPECT_TRUE(seen.see({a, nullptr}));
  EXPECT_FALSE(seen.see({a, nullptr}));
  EXPECT_TRUE(seen.see({a, b}));
  EXPECT_TRUE(seen.see({b, a}));
  EXPECT_TRUE(seen.see({}));
}

// Results come and go, and the memory of one that is gone serves the next.
TEST(ObjectsSeen, AnAddressThatComesBackIsAnother) {
  ObjectsSeen<1> seen;
  std::set<const void*> addresses;
  int cameBack = 0;
  for (int i = 0; i < 100; ++i) {
    const std::shared_ptr<const std::vector<int>> object(new std::vector<int>(1000));
    cameBack += !addresses.insert(object.get()).second;
    EXPECT_TRUE(seen.see({object})) << i;
  }
#if !defined(__SANITIZE_ADDRESS__)  // which gives no address twice for a long time
  EXPECT_GT(cameBack, 0) << "nothing was tested";
#endif
}

}  // namespace
}  // namespace sonoskin
