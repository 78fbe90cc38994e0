#include "core/pipeline/presets.h"

#include <gtest/gtest.h>

#include <set>

#include "core/base/error.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/check_ranges.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/recipe.h"

namespace sonoskin {
namespace {

Parameters applied(std::string_view name) {
  Parameters p;
  applyPreset(findPreset(name), p);
  return p;
}

TEST(Presets, HaveNamesSentencesAndAllowedValues) {
  std::set<std::string_view> names;
  for (const Preset& preset : presets()) {
    EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
    EXPECT_FALSE(preset.help.empty());
    EXPECT_EQ(preset.help.find('\n'), std::string_view::npos);
    EXPECT_NE(preset.help.back(), '.');
    EXPECT_NO_THROW(checkRanges(applied(preset.name))) << preset.name;
  }
  EXPECT_EQ(presets()[0].name, "default");
}

TEST(Presets, ReplaceOneAnother) {
  for (const Preset& preset : presets()) {
    Parameters p = applied("thesis-baby-1");
    p.classification.noiseFloor = 0.1;
    applyPreset(preset, p);
    EXPECT_EQ(writeRecipe(p), writeRecipe(applied(preset.name)));
  }
  EXPECT_EQ(writeRecipe(applied("default")), writeRecipe({}));
}

TEST(Presets, LeaveTheScanAndTheChoiceOfAPieceAlone) {
  for (const Preset& preset : presets()) {
    Parameters p;
    p.phantom.seed = 7;
    p.scan.probeSide = VolumeSide::kLow;
    p.mesh.piece = PieceChoice::largest;
    applyPreset(preset, p);
    EXPECT_EQ(p.phantom.seed, 7);
    EXPECT_EQ(p.scan.probeSide, VolumeSide::kLow);
    EXPECT_EQ(p.mesh.piece, PieceChoice::largest);
  }
}

TEST(Presets, AreKnownByTheirValues) {
  for (const Preset& preset : presets()) {
    Parameters p = applied(preset.name);
    p.phantom.seed = 7;
    ASSERT_NE(matchingPreset(p), nullptr) << preset.name;
    EXPECT_EQ(matchingPreset(p)->name, preset.name);
    p.surface.threshold *= 0.5;
    EXPECT_EQ(matchingPreset(p), nullptr);
  }
}

// Chapter 4 of the thesis: table 4.1, the line above it, and table 4.2.
TEST(Presets, OfTheThesisHaveItsNumbers) {
  const Parameters one = applied("thesis-baby-1"), two = applied("thesis-baby-2");
  EXPECT_EQ(one.classification.alpha, 0.7);
  EXPECT_EQ(one.classification.beta, 0.2);
  EXPECT_EQ(one.classification.gamma, 0.7);
  EXPECT_EQ(one.classification.isoValue, 0.6);
  EXPECT_EQ(two.classification.alpha, 0.9);
  EXPECT_EQ(two.classification.beta, 0.2);
  EXPECT_EQ(two.classification.gamma, 0.4);
  EXPECT_EQ(two.classification.isoValue, 0.3);
  for (const Parameters& p : {one, two}) {
    EXPECT_NE(p.classification.formulation, Formulation::variational);
    EXPECT_EQ(p.classification.rawShare, 0.5);
    EXPECT_EQ(p.classification.gradientFloor, 0.5);
    EXPECT_EQ(p.classification.target, 0.9);
    EXPECT_EQ(p.reconstruction.regularisation, 1e-6);
    EXPECT_EQ(p.mesh.resolution, 400);
  }
  EXPECT_EQ(one.reconstruction.smoothness, 2e-5);
  EXPECT_EQ(two.reconstruction.smoothness, 1e-4);
}

TEST(Presets, AnUnknownOneIsRefusedWithTheNamesOfAll) {
  try {
    findPreset("best");
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::usage);
    for (const Preset& preset : presets())
      EXPECT_NE(std::string(error.what()).find(preset.name), std::string::npos) << error.what();
  }
}

TEST(Presets, AllFindASurfaceOfTheSimulatedScan) {
  PhantomOptions options;
  options.dims = {112, 64, 36};
  const Scan scan = makePhantomScan(options);
  Pipeline pipeline;
  for (const Preset& preset : presets())
    EXPECT_GT(pipeline.run(scan, applied(preset.name), Goal::points).points->size(), 200u) << preset.name;
}

}  // namespace
}  // namespace sonoskin
