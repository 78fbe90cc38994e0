// `sonoskin phantom` from outside: scenes, heads, the true skin.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "core/io/mesh_reader.h"
#include "core/phantom/phantom.h"
#include "tests/app/cli_support.h"

namespace sonoskin::test {
namespace {

TEST(PhantomCommand, WritesASceneOfAHeadWithItsLabelledSkin) {
  const TempFolder folder;
  const std::string volume = (folder / "v.nrrd").string(), skin = (folder / "t.ply").string();
  const ProgramResult result = sonoskin({"phantom", "--out", volume, "--truth", skin, "--dims", "64x36x24",
                                         "--scene", "attached", "--shape", "2", "--seed", "3", "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto report = nlohmann::json::parse(result.out);
  EXPECT_EQ(report["scene"], "attached");
  EXPECT_EQ(report["shape"], 2);
  PhantomOptions options;
  options.dims = {64, 36, 24};
  options.scene = PhantomScene::attached;
  options.shape = 2;
  options.seed = 3;
  EXPECT_EQ(report["key"], makePhantomScan(options).key.hex());
  const Mesh truth = readMesh(skin);
  ASSERT_EQ(truth.labels.size(), truth.positions.size());
  EXPECT_EQ(std::set<int>(truth.labels.begin(), truth.labels.end()), (std::set<int>{1, 2, 3, 4}));
}

TEST(PhantomCommand, RefusesASceneThatDoesNotExist) {
  const TempFolder folder;
  const ProgramResult result = sonoskin({"phantom", "--out", (folder / "v.nrrd").string(), "--scene", "fog"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("fog"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace sonoskin::test
