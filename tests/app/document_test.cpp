// What belongs to the baby, and what to one moment of it.
#include "app/document/document.h"

#include <gtest/gtest.h>

#include "app/document/frame.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

Opened volumeOf(const glm::ivec3& dims, const char* name) {
  Opened opened;
  auto volume = std::make_shared<Volume<float>>(test::grid(dims));
  opened.scan.key = Hasher(name).key();
  opened.scan.volume = std::move(volume);
  opened.name = name;
  return opened;
}

const Brush kBrush{{4, 4, 4}, {4, 4, 4}, 3, true};

TEST(Document, UndoBringsBackParametersAndStrokesInTheirOrder) {
  Document document{Parameters{}};
  document.adopt(volumeOf({20, 20, 20}, "a"), {});
  ASSERT_TRUE(document.erased.paint(kBrush));
  document.commit();
  const Key painted = document.erased.key();
  Parameters changed = document.parameters;
  changed.mesh.resolution = 77;
  document.change(changed);
  document.undo();  // commits what was changed, and takes it back
  EXPECT_EQ(document.parameters.mesh.resolution, Parameters{}.mesh.resolution);
  EXPECT_EQ(document.erased.key(), painted);
  document.undo();
  EXPECT_EQ(document.erased.voxels(), 0u);
  EXPECT_FALSE(document.history.canUndo());
  document.redo();
  document.redo();
  EXPECT_EQ(document.parameters.mesh.resolution, 77);
  EXPECT_EQ(document.erased.key(), painted);
}

TEST(Document, IsWithinItsRangesWhoeverChangesIt) {
  Parameters wild;
  wild.classification.gamma = -5;
  Document document(wild);
  EXPECT_GE(document.parameters.classification.gamma, 0);
  wild.classification.gamma = 1e9;
  document.change(wild);
  EXPECT_LT(document.parameters.classification.gamma, 1e9);
}

// What was left out when a volume was read is told by its recipe, whatever is asked for the next one.
TEST(Document, ItsRecipeSaysHowItWasRead) {
  Document document{Parameters{}};
  Opened opened = volumeOf({20, 20, 20}, "a");
  opened.reading.half = true;
  document.adopt(opened, {});
  EXPECT_FALSE(document.parameters.scan.half);
  EXPECT_TRUE(recipeParameters(document).scan.half);
  Parameters changed = document.parameters;
  changed.scan.cutLow = {1, 2, 3};
  document.change(changed);
  EXPECT_EQ(recipeParameters(document).scan.cutLow, (std::array<double, 3>{0, 0, 0}));
}

// A crop box is kept for a volume of the same dimensions, landmarks for the same scan alone.
TEST(Document, WhatBelongsToAVolumeGoesWithIt) {
  const Opened first = volumeOf({20, 20, 20}, "a"), same = volumeOf({20, 20, 20}, "b"),
               larger = volumeOf({24, 20, 20}, "c");
  Document document{Parameters{}};
  document.adopt(first, {});
  Parameters changed = document.parameters;
  changed.region.cutLow[0] = 3;
  changed.landmarks.noseTip = {1, 2, 3};
  document.change(changed);
  document.erased.paint(kBrush);
  document.commit();
  document.adopt(same, first.scan);
  EXPECT_EQ(document.name, "b");
  EXPECT_EQ(document.parameters.region.cutLow[0], 3);
  EXPECT_EQ(document.parameters.landmarks, LandmarkOptions{});
  EXPECT_EQ(document.erased.voxels(), 0u);
  EXPECT_FALSE(document.history.canUndo());
  document.adopt(larger, same.scan);
  EXPECT_EQ(document.parameters.region.cutLow[0], 0);
}

// A slider's answer has neither mesh nor face: those of the frame stay, and the mesh tells what it was made from.
TEST(Frame, KeepsWhatNewerResultsLack) {
  Document document{Parameters{}};
  Frame frame;
  frame.scan = volumeOf({20, 20, 20}, "a").scan;
  Results full;
  full.mesh = std::make_shared<Mesh>();
  full.points = std::make_shared<SurfacePoints>();
  full.face = std::make_shared<FaceFit>();
  full.centres = 9;
  full.isFinal = true;
  const auto mesh = full.mesh;
  const auto points = full.points;
  EXPECT_FALSE(meshIsCurrent(document, frame));
  takeIn(frame, full, {document.parameters, nullptr, keysOf(document, frame).mesh}, {});
  EXPECT_TRUE(meshIsCurrent(document, frame));
  EXPECT_TRUE(frame.made.isFinal);

  document.parameters.classification.gamma = 2;
  Results answer;
  answer.classified = std::make_shared<const Volume<float>>(test::grid(glm::ivec3(10)));
  takeIn(frame, answer, {document.parameters, nullptr, keysOf(document, frame).mesh}, {});
  EXPECT_EQ(frame.results.classified, answer.classified);
  EXPECT_EQ(frame.results.mesh, mesh);
  EXPECT_EQ(frame.results.points, points);
  EXPECT_TRUE(frame.results.face);
  EXPECT_EQ(frame.results.centres, 9u);
  EXPECT_FALSE(meshIsCurrent(document, frame));
  EXPECT_NE(frame.made.parameters.classification.gamma, 2);
}

// Several moments: one document leads each to results of its own.
TEST(Frame, AnotherMomentHasOtherKeysOfTheSameDocument) {
  const Document document{Parameters{}};
  Frame first, second;
  first.scan.key = Hasher("first").key();
  second.scan.key = Hasher("second").key();
  EXPECT_NE(keysOf(document, first).classified, keysOf(document, second).classified);
  EXPECT_NE(keysOf(document, first).mesh, keysOf(document, second).mesh);
  second.scan.key = first.scan.key;
  EXPECT_EQ(keysOf(document, first).mesh, keysOf(document, second).mesh);
}

}  // namespace
}  // namespace sonoskin
