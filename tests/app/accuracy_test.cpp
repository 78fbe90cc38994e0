// The whole way against the truth: the mesh of a simulated scan beside the skin that it was made from.
// The bounds are those of the full size (467x255x124) scaled to voxels that are twice as large; there they are RMS 1 mm
// and 95 % under 2 mm.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/cli_support.h"

namespace sonoskin::test {
namespace {

TEST(Accuracy, MeshOfThePhantomLiesOnItsTrueSkin) {
  const TempFolder folder;
  const std::string out = (folder / "out").string();
  const ProgramResult run =
      sonoskin({"run", "phantom", "--out", out, "--phantom.dims", "234x128x62", "--size", "64x64"});
  ASSERT_EQ(run.status, 0) << run.err;
  const ProgramResult compared = sonoskin({"compare", out + "/mesh.ply", out + "/truth.ply", "--json"});
  ASSERT_EQ(compared.status, 0) << compared.err;
  const nlohmann::json distances = nlohmann::json::parse(compared.out);

  const nlohmann::json& seen = distances["visible_a_to_b"];
  EXPECT_LT(seen["rms_mm"].get<double>(), 1.5);
  EXPECT_LT(seen["p95_mm"].get<double>(), 2.5);
  EXPECT_LT(seen["normal_angle_deg"].get<double>(), 20);
  // It is the baby and a good part of what can be seen of it, not the wall of the uterus or a speck.
  EXPECT_GT(seen["area_mm2"].get<double>(), 0.5 * distances["visible_b_to_a"]["area_mm2"].get<double>());
  EXPECT_LT(distances["a_to_b"]["p95_mm"].get<double>(), 4);
  // Echoes are thick: the surface lies outside the skin, by a constant that is known to be below two voxels.
  EXPECT_GT(seen["signed_median_mm"].get<double>(), -0.3);
  EXPECT_LT(seen["signed_median_mm"].get<double>(), 1.2);
}

}  // namespace
}  // namespace sonoskin::test
