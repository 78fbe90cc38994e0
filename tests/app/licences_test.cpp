#include "app/panels/licences.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace sonoskin::ui {
namespace {

// That every library that is linked is among them is CMake's to see: app/licences.cmake.
TEST(Licences, TellNameLicenceAndTextOfEach) {
  ASSERT_GT(licences().size(), 20u);
  EXPECT_STREQ(licences()[0].name, "Sonoskin");
  std::set<std::string> names;
  for (const Licence& part : licences()) {
    EXPECT_TRUE(names.insert(part.name).second) << part.name;
    EXPECT_STRNE(part.licence, "") << part.name;
    const std::string text = part.text;
    EXPECT_GT(text.size(), 500u) << part.name;
    EXPECT_NE(text.find("opyright"), std::string::npos) << part.name;
  }
  for (const char* name : {"Dear ImGui", "GLFW", "ITK", "Eigen", "Inter"})
    EXPECT_TRUE(names.contains(name)) << name;
}

}  // namespace
}  // namespace sonoskin::ui
