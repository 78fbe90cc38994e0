#include "core/pipeline/pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/facts/mesh_check.h"
#include "tests/core/support/pipeline_fixture.h"

namespace sonoskin {
namespace {

TEST_F(PipelineTest, MakesTheFrontOfTheBall) {
  parameters.surface.sides = 0;
  parameters.surface.skinDepth = 0;  // the ball's border is where its grey is steepest
  const Results r = pipeline.run(scan, parameters, Goal::mesh);
  ASSERT_GT(r.mesh->triangles.size(), 1000u);
  double sum = 0, squares = 0;
  for (const glm::vec3& p : r.mesh->positions) {
    const double offset = glm::length(glm::dvec3(p) - kCentre) - kRadius;
    sum += offset;
    squares += offset * offset;
    EXPECT_LT(double(p.y), kCentre.y + 1);  // only what faces the probe
  }
  const double mean = sum / double(r.mesh->positions.size());
  const double spread = std::sqrt(squares / double(r.mesh->positions.size()) - mean * mean);
  EXPECT_LT(std::abs(mean), 0.6) << "two voxels: the iso-value lies at the foot of the edge";
  EXPECT_LT(spread, 0.1) << "a third of a voxel around it";
  for (std::size_t v = 0; v < r.mesh->positions.size(); ++v)
    EXPECT_GT(glm::dot(r.mesh->normals[v], r.mesh->positions[v] - glm::vec3(kCentre)), 0)
        << "normals point outward";
}

TEST_F(PipelineTest, RepeatsOnlyWhatDependsOnAChange) {
  const Results first = pipeline.run(scan, parameters, Goal::mesh);
  EXPECT_TRUE(computed(pipeline.run(scan, parameters, Goal::mesh)).empty());

  Parameters changed = parameters;
  changed.reconstruction.smoothness *= 2;
  const Results second = pipeline.run(scan, changed, Goal::mesh);
  EXPECT_EQ(computed(second), (std::vector<std::string>{"fit", "surface", "parts", "piece"}));
  EXPECT_EQ(second.points, first.points);

  const Results back = pipeline.run(scan, parameters, Goal::mesh);
  EXPECT_TRUE(computed(back).empty());
  EXPECT_EQ(back.mesh, first.mesh);
}

TEST_F(PipelineTest, TheGlobalFunctionFindsTheSameFront) {
  const Results adaptive = pipeline.run(scan, parameters, Goal::mesh);
  parameters.reconstruction.method = ReconstructionMethod::global;
  const Results r = pipeline.run(scan, parameters, Goal::mesh);
  EXPECT_EQ(computed(r), (std::vector<std::string>{"fit", "surface", "parts", "piece"}));
  ASSERT_GT(r.mesh->triangles.size(), 1000u);
  for (const glm::vec3& p : r.mesh->positions)
    EXPECT_NEAR(glm::length(glm::dvec3(p) - kCentre), kRadius, 0.9);
  EXPECT_NE(r.centres, adaptive.centres);
  EXPECT_GT(r.globalError, 0);
  EXPECT_LT(r.globalError, 0.02);
}

// The parameters of the other method do not cost a new fit.
TEST_F(PipelineTest, EachMethodOfReconstructionHasItsOwnKey) {
  parameters.reconstruction.method = ReconstructionMethod::global;
  pipeline.run(scan, parameters, Goal::mesh);
  parameters.reconstruction.smoothness *= 2;
  EXPECT_TRUE(computed(pipeline.run(scan, parameters, Goal::mesh)).empty());
  parameters.global.accuracy *= 2;
  EXPECT_EQ(computed(pipeline.run(scan, parameters, Goal::mesh)).front(), "fit");
  parameters.reconstruction.method = ReconstructionMethod::adaptive;
  pipeline.run(scan, parameters, Goal::mesh);
  parameters.global.accuracy *= 2;
  EXPECT_TRUE(computed(pipeline.run(scan, parameters, Goal::mesh)).empty());
}

TEST_F(PipelineTest, OtherPiecesCostNoNewSurface) {
  pipeline.run(scan, parameters, Goal::mesh);
  parameters.mesh.piece = PieceChoice::largest;
  EXPECT_EQ(computed(pipeline.run(scan, parameters, Goal::mesh)), std::vector<std::string>{"piece"});
}

TEST_F(PipelineTest, CleaningAndPrintingFollowThePiece) {
  const Results plain = pipeline.run(scan, parameters, Goal::mesh);
  EXPECT_FALSE(plain.print);
  parameters.mesh.triangles = 1000;
  const Results clean = pipeline.run(scan, parameters, Goal::mesh);
  EXPECT_EQ(computed(clean), std::vector<std::string>{"clean"});
  EXPECT_LT(clean.mesh->triangles.size(), plain.mesh->triangles.size() / 2);
  parameters.print.form = PrintForm::block;
  const Results solid = pipeline.run(scan, parameters, Goal::mesh);
  EXPECT_EQ(computed(solid), std::vector<std::string>{"print"});
  EXPECT_EQ(solid.mesh, clean.mesh);
  ASSERT_TRUE(solid.print);
  EXPECT_TRUE(checkMesh(*solid.print).closed());
  parameters.print.scale = 2;
  EXPECT_NEAR(enclosedVolume(*pipeline.run(scan, parameters, Goal::mesh).print),
              8 * enclosedVolume(*solid.print), 1e-3 * enclosedVolume(*solid.print));
}

TEST_F(PipelineTest, EnhancementIsDoneOnceAndReachesEverythingBehindIt) {
  const Results plain = pipeline.run(scan, parameters, Goal::points);
  Parameters changed = parameters;
  changed.enhancement.method = EnhancementMethod::diffusion;
  const Results enhanced = pipeline.run(scan, changed, Goal::points);
  EXPECT_EQ(computed(enhanced),
            (std::vector<std::string>{"enhancement", "low-pass", "classification", "points", "evidence"}));
  EXPECT_NE(enhanced.classified->data, plain.classified->data);
  EXPECT_NE(pipeline.preview(scan, changed, Preview::half).classified->data,
            pipeline.preview(scan, parameters, Preview::half).classified->data);
  changed.classification.lowPass = 1.2;
  EXPECT_EQ(computed(pipeline.run(scan, changed, Goal::points)),
            (std::vector<std::string>{"low-pass", "classification", "points", "evidence"}));
}

// A cut or an eraser asks for new points, not for a new classification; going back costs nothing.
TEST_F(PipelineTest, TheRegionReachesThePointsAlone) {
  const Results whole = pipeline.run(scan, parameters, Goal::points);
  Parameters cut = parameters;
  cut.region.cutLow[0] = 9;  // the middle of the ball
  const Results half = pipeline.run(scan, cut, Goal::points);
  EXPECT_EQ(computed(half), (std::vector<std::string>{"points", "evidence"}));
  EXPECT_EQ(half.classified, whole.classified);
  EXPECT_EQ(half.isoValue, whole.isoValue);
  EXPECT_NEAR(double(half.points->size()), 0.5 * double(whole.points->size()),
              0.05 * double(whole.points->size()));
  for (const glm::vec3& p : half.points->positions) EXPECT_GT(p.x, 8.5f);

  Scan erased = scan;
  auto mask = std::make_shared<Volume<std::uint8_t>>(scan.volume->geometry);
  for (std::size_t v = 0; v < mask->data.size(); ++v) mask->data[v] = v % 60 < 30;
  erased.erased = mask;
  erased.erasedKey = Hasher("left half").key();
  const Results right = pipeline.run(erased, parameters, Goal::points);
  EXPECT_EQ(computed(right), (std::vector<std::string>{"points", "evidence"}));
  EXPECT_GT(double(right.points->size()), 0.45 * double(whole.points->size()));
  for (const glm::vec3& p : right.points->positions) EXPECT_GT(p.x, 8.5f);

  const Results back = pipeline.run(scan, parameters, Goal::points);
  EXPECT_TRUE(computed(back).empty());
  EXPECT_EQ(back.points, whole.points);
}

TEST_F(PipelineTest, GoalsEndTheWayEarlier) {
  const Results levels = pipeline.run(scan, parameters, Goal::levels);
  EXPECT_FALSE(levels.classified);
  EXPECT_EQ(levels.visibleLevel, pipeline.run(scan, parameters, Goal::classified).visibleLevel);
  EXPECT_FALSE(pipeline.run(scan, parameters, Goal::classified).points);
  EXPECT_FALSE(pipeline.run(scan, parameters, Goal::points).mesh);
}

TEST_F(PipelineTest, SameBitsOnAnyNumberOfThreads) {
  setThreadCount(1);
  const Results one = pipeline.run(scan, parameters, Goal::mesh);
  setThreadCount(3);
  Pipeline other;
  const Results three = other.run(scan, parameters, Goal::mesh);
  setThreadCount(0);
  EXPECT_EQ(one.mesh->positions, three.mesh->positions);
  EXPECT_EQ(one.mesh->triangles, three.mesh->triangles);
}

TEST_F(PipelineTest, CancelLeavesTheMemoryAsItWas) {
  const Results before = pipeline.run(scan, parameters, Goal::mesh);
  ProgressSink sink;
  double reached = 0;
  sink.report = [&](double fraction) {
    reached = fraction;
    sink.cancel = fraction > 0.3;
  };
  Parameters changed = parameters;
  changed.classification.gamma *= 1.5;
  EXPECT_THROW(pipeline.run(scan, changed, Goal::mesh, Progress(sink)), Cancelled);
  EXPECT_LT(reached, 0.9);
  EXPECT_TRUE(computed(pipeline.run(scan, parameters, Goal::mesh)).empty());
}

TEST_F(PipelineTest, ProgressNeverFallsBack) {
  ProgressSink sink;
  double last = 0;
  std::map<std::string, double> begins;
  sink.report = [&](double fraction) {
    EXPECT_GE(fraction, last - 0.06);  // the solver's residual may rise for an iteration
    last = std::max(last, fraction);
  };
  pipeline.run(scan, parameters, Goal::mesh, Progress(sink),
               [&](const std::string& name) { begins[name] = last; });
  EXPECT_GT(last, 0.9);
  EXPECT_LE(last, 1.0);
  EXPECT_LT(begins["classification"], begins["fit"]);
}

TEST_F(PipelineTest, PreviewsAreTheSameSurfaceWithFewerVoxels) {
  const Results full = pipeline.run(scan, parameters, Goal::classified);
  const auto brightest = [](const Volume<float>& u) {  // along the beam through the middle of the ball
    const glm::ivec3 at(u.geometry.toIndex(kCentre) + 0.5);
    double best = 0, where = 0;
    for (int j = 0; j < at.y; ++j)
      if (double(u.at(at.x, j, at.z)) > best) {
        best = double(u.at(at.x, j, at.z));
        where = u.geometry.toWorld({at.x, j, at.z}).y;
      }
    return where;
  };
  std::size_t voxels = full.classified->data.size();
  double voxel = 0.6;  // mm
  for (const Preview level : {Preview::half, Preview::quarter}) {
    const Results coarse = pipeline.preview(scan, parameters, level);
    EXPECT_LT(coarse.classified->data.size(), voxels / 3);
    EXPECT_NEAR(brightest(*coarse.classified), brightest(*full.classified), voxel + 0.01);
    EXPECT_EQ(coarse.isoValue, full.isoValue);
    voxels = coarse.classified->data.size();
    voxel *= 2;
  }
}

// What sliders show lies within 0.02 of what a mesh is made from; once that is there, it is shown.
TEST_F(PipelineTest, LiveAnswersAreNearTheFinalOne) {
  pipeline.run(scan, parameters, Goal::classified);
  parameters.classification.gamma = 1.3;
  const Results live = pipeline.run(scan, parameters, Goal::points);
  const Results final = pipeline.run(scan, parameters, Goal::mesh);
  EXPECT_NE(live.classified, final.classified);
  for (std::size_t v = 0; v < live.classified->data.size(); ++v)
    ASSERT_NEAR(live.classified->data[v], final.classified->data[v], 0.02);
  EXPECT_EQ(pipeline.run(scan, parameters, Goal::classified).classified, final.classified);
}

TEST_F(PipelineTest, SaysSoWhenThereIsNoSurface) {
  Scan empty = scan;
  empty.volume = std::make_shared<const Volume<float>>(scan.volume->geometry);
  empty.key = scanKey(*empty.volume, {});
  try {
    pipeline.run(empty, parameters, Goal::mesh);
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("no surface was found"), std::string::npos);
  }
}

TEST_F(PipelineTest, RefusesParametersOutOfRange) {
  parameters.classification.alpha = -1;
  EXPECT_THROW(pipeline.run(scan, parameters, Goal::mesh), Error);
}

TEST_F(PipelineTest, PreviewOfTheSkewSystemIsItsClosedForm) {
  parameters.classification.formulation = Formulation::thesisSkew;
  parameters.classification.beta = 4;
  const Results skew = pipeline.preview(scan, parameters, Preview::half);
  parameters.classification.formulation = Formulation::thesisClosed;
  EXPECT_EQ(skew.classified->data, pipeline.preview(scan, parameters, Preview::half).classified->data);
}

// However many answers a slider has had, what is remembered keeps within its budget, and going back to what was asked for
// costs nothing.
// What is looked at is answered from a few voxels around it.
TEST_F(PipelineTest, RemembersWithinItsBudget) {
  std::size_t budget = 4 * scan.volume->data.size() * sizeof(float);  // and what was asked for
  for (const StageReport& stage : pipeline.run(scan, parameters, Goal::mesh).stages) budget += stage.bytes;
  Pipeline bounded(budget);
  std::weak_ptr<const Volume<float>> asked = bounded.run(scan, parameters, Goal::mesh).classified;
  std::vector<std::weak_ptr<const Volume<float>>> answers;
  Parameters changed = parameters;
  for (int n = 0; n < 8; ++n) {
    changed.classification.gamma *= 1.05;
    answers.push_back(bounded.run(scan, changed, Goal::points).classified);
    ASSERT_LE(std::ranges::count_if(answers, [](const auto& a) { return !a.expired(); }), 4);
  }
  EXPECT_TRUE(answers.front().expired());
  EXPECT_FALSE(answers.back().expired());
  EXPECT_FALSE(asked.expired());
  EXPECT_TRUE(computed(bounded.run(scan, parameters, Goal::mesh)).empty());

  Pipeline small(1);  // no room for anything but the run itself
  Results once = small.run(scan, parameters, Goal::mesh);
  EXPECT_TRUE(computed(small.run(scan, parameters, Goal::mesh)).empty());
  changed.enhancement.method = EnhancementMethod::diffusion;  // nothing of it is used any more
  asked = once.classified;
  once = small.run(scan, changed, Goal::mesh);
  EXPECT_TRUE(asked.expired());
}

TEST_F(PipelineTest, ForgetsWhenItIsTold) {
  std::weak_ptr<const Volume<float>> classified = pipeline.run(scan, parameters, Goal::points).classified;
  std::weak_ptr<const Volume<float>> coarse = pipeline.preview(scan, parameters, Preview::half).classified;
  ASSERT_FALSE(classified.expired() || coarse.expired());
  pipeline.forget();
  EXPECT_TRUE(classified.expired() && coarse.expired());
  EXPECT_FALSE(computed(pipeline.run(scan, parameters, Goal::points)).empty());
}

// What a slider's answer left out, the face, is not what a mesh that is asked for later is made from.
TEST_F(PipelineTest, ASurfaceBeforeTheMeshDoesNotChangeIt) {
  pipeline.run(scan, parameters, Goal::mesh);
  parameters.surface.minClusterArea *= 2;  // the classification stays the final one
  const Results live = pipeline.run(scan, parameters, Goal::surface);
  EXPECT_FALSE(live.face);
  EXPECT_FALSE(live.isFinal);
  const Results later = pipeline.run(scan, parameters, Goal::mesh);
  EXPECT_TRUE(later.face && later.isFinal);
  const std::vector<std::string> stages = computed(later);
  EXPECT_EQ(std::ranges::count(stages, "piece"), 1) << "it was chosen without a face before";
  const Results again = pipeline.run(scan, parameters, Goal::surface);
  EXPECT_TRUE(again.isFinal);
  EXPECT_EQ(again.mesh, later.mesh);
}

}  // namespace
}  // namespace sonoskin
