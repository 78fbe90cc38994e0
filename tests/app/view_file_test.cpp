// Views in a session file.
#include "app/workspace/view_file.h"

#include <gtest/gtest.h>

#include "app/document/measure_file.h"

namespace sonoskin {
namespace {

TEST(ViewFile, ReadsBackWhatItWrote) {
  ViewState view;
  view.cursor = {1.25, -2.5, 1.0 / 3};
  view.grey = {0.3f, 0.7f};
  view.layer = SliceLayer::thinned;
  view.slices[1] = {.pan = {3, -4.1}, .zoom = 2.7};
  view.content = SpaceContent::mesh;
  view.volumeStyle = VolumeStyle::translucent;
  view.volumeLevel = 0.37;
  view.skin.compare = SkinCompare::settings;
  view.skin.kept = SkinSettings{};
  view.skin.kept->skin.melanin = 0.011;
  view.skin.kept->light.azimuth = 33;
  view.camera.target = {1, 2, 3};
  view.camera.forward = {0, 0, -1};
  view.camera.up = {0, 1, 0};
  view.camera.distance = 123.4f;
  view.orientation.planes = PlanesChoice::scanner;
  view.orientation.turn = glm::dmat3(0, 1, 0, -1, 0, 0, 0, 0, 1);
  view.maximised = Pane::coronal;
  view.measures = {{MeasureKind::angle, {{1, 2, 3}, {4, 5, 6}, {7, 8, 10}}},
                   {MeasureKind::distance, {{0, 0, 0}, {0, 3, 4}}}};
  view.slicePoints = true;
  ViewState read;
  readViews(writeViews(view), read);
  EXPECT_EQ(writeViews(read), writeViews(view));
  EXPECT_EQ(read.cursor, view.cursor);
  EXPECT_EQ(read.maximised, Pane::coronal);
  EXPECT_EQ(read.measures, view.measures);
  EXPECT_EQ(read.skin.kept->skin.melanin, 0.011);
  EXPECT_EQ(read.camera.forward, view.camera.forward);
  view.maximised.reset();
  readViews(writeViews(view), read);
  EXPECT_FALSE(read.maximised);
}

// Anybody may have written it.
TEST(ViewFile, WhatCannotBeUsedIsLeft) {
  const ViewState usual;
  ViewState view;
  for (const char* text :
       {"", "[]", "3", "{", R"({"cursor": "x", "layer": 7, "slices": [1, 2], "camera": []})",
        R"({"layer": "no such", "unheard": 3, "grey": {"level": "a"}})"})
    readViews(text, view);
  EXPECT_EQ(writeViews(view), writeViews(usual));
  readViews(R"({"grey": {"width": -3}, "brushRadius": 1e300, "cursor": [1e300, 0, 0],
                "orientation": {"turn": [[5, 0, 0], [0, 1, 0], [0, 0, 1]]}, "camera": {"forward": [0, 0, 0], "distance": 7}})",
            view);
  readViews(
      R"({"measures": [{"kind": "area", "marks": [[0, 0, 0]]}, {"kind": "distance", "marks": [[0, 0, 0], [0, 0, 2]]}, 7]})",
      view);
  EXPECT_EQ(view.measures.size(), 1u) << "those without all of their marks are none";
  EXPECT_GT(view.grey.width, 0);
  EXPECT_EQ(view.brushRadius, kMostBrush);
  EXPECT_LE(view.cursor.x, 1e6);
  EXPECT_EQ(view.orientation.turn, glm::dmat3(1));
  EXPECT_EQ(view.camera.distance, usual.camera.distance) << "a camera is taken whole or not";
}

TEST(ViewFile, AsManyMeasuresAsMayBeMadeAreReadBack) {
  ViewState view, read;
  view.measures.assign(kMostMeasures, {MeasureKind::distance, {{0, 0, 0}, {0, 3, 4}}});
  readViews(writeViews(view), read);
  EXPECT_EQ(read.measures, view.measures);
  view.measures = {{MeasureKind::area, std::vector<glm::dvec3>(kMostMarks, {1, 2, 3})}};
  readViews(writeViews(view), read);
  EXPECT_EQ(read.measures, view.measures);
}

}  // namespace
}  // namespace sonoskin
