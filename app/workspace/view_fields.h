#pragma once

#include <array>
#include <string_view>

#include "app/workspace/view_state.h"
#include "core/base/fields.h"

namespace sonoskin {

// What of the views goes into a session file: a line a member, with its name there and, for numbers, its range; without a
// range as far as a scan may lie. What a person only holds for a moment, tools and what the views tell, is not listed.
// Members are numbers, bools, enums with enumNames(), vectors and matrices of glm, structs that list theirs, and arrays, optionals and
// vectors of these (app/workspace/view_file.h).

constexpr std::array<const char*, 3> enumNames(SliceLayer) { return {"raw", "classified", "thinned"}; }
constexpr std::array<const char*, 2> enumNames(VolumeLayer) { return {"raw", "classified"}; }
constexpr std::array<const char*, 2> enumNames(SpaceContent) { return {"volume", "mesh"}; }
constexpr std::array<const char*, 3> enumNames(VolumeStyle) { return {"surface", "translucent", "maximum"}; }
constexpr std::array<const char*, 2> enumNames(MeshStyle) { return {"clay", "skin"}; }
constexpr std::array<const char*, 5> enumNames(Pane) {
  return {"axial", "space", "sagittal", "coronal", "oblique"};
}
constexpr std::array<const char*, 3> enumNames(SkinCompare) { return {"off", "scatter", "settings"}; }

template <class F, class O>
requires OptionsOf<O, SlicePose>
void fields(F&& f, O& o) {
  f("pan", o.pan);
  f("zoom", o.zoom, Range{0.01, 1000.0});
}

template <class F, class O>
requires OptionsOf<O, ObliqueShow>
void fields(F&& f, O& o) {
  f("right", o.directions.right, Range{-1.0, 1.0});
  f("down", o.directions.down, Range{-1.0, 1.0});
  f("pose", o.pose);
}

template <class F, class O>
requires OptionsOf<O, GreyWindow>
void fields(F&& f, O& o) {
  f("level", o.level, Range{-10.f, 10.f});
  f("width", o.width, Range{1e-4f, 20.f});
}

template <class F, class O>
requires OptionsOf<O, Camera>
void fields(F&& f, O& o) {
  f("target", o.target);
  f("forward", o.forward);
  f("up", o.up);
  f("distance", o.distance, Range{kLeastDistance, 1e6f});
  f("fieldOfView", o.fieldOfView, Range{1.f, 120.f});
}

template <class F, class O>
requires OptionsOf<O, SkinSettings>
void fields(F&& f, O& o) {
  f("skin", o.skin);
  f("light", o.light);
  f("landmarks", o.landmarks);
}

template <class F, class O>
requires OptionsOf<O, SkinShow>
void fields(F&& f, O& o) {
  f("pass", o.pass);
  f("compare", o.compare);
  f("divider", o.divider, Range{0.f, 1.f});
  f("kept", o.kept);
  f("lamp", o.lamp);
  f("reach", o.reach);
  f("places", o.places);
}

template <class F, class O>
requires OptionsOf<O, Orientation>
void fields(F&& f, O& o) {
  f("planes", o.planes);
  f("turn", o.turn);
}

template <class F, class O>
requires OptionsOf<O, Measure>
void fields(F&& f, O& o) {
  f("kind", o.kind);
  f("marks", o.marks);
}

template <class F, class O>
requires OptionsOf<O, TransferFunction::Point>
void fields(F&& f, O& o) {
  f("value", o.value, Range{0.f, 1.f});
  f("colour", o.colour, Range{0.f, 1.f});
  f("opacity", o.opacity, Range{0.f, 1.f});
}

template <class F, class O>
requires OptionsOf<O, LevelledTransfer>
void fields(F&& f, O& o) {
  f("points", o.function.points);
  f("level", o.level, Range{0.f, 1.f});
}

template <class F, class O>
requires OptionsOf<O, VolumeShow>
void fields(F&& f, O& o) {
  f("colours", o.colours);
  f("own", o.own);
  f("changed", o.changed);
  f("shadows", o.shadows);
  f("mesh", o.mesh);
}

template <class F, class O>
requires OptionsOf<O, ClipShow>
void fields(F&& f, O& o) {
  f("on", o.on);
  f("normal", o.plane.normal, Range{-1.f, 1.f});
  f("offset", o.plane.offset);
}

template <class F, class O>
requires OptionsOf<O, ViewState>
void fields(F&& f, O& o) {
  f("cursor", o.cursor);
  f("grey", o.grey);
  f("layer", o.layer);
  f("surfaceVoxels", o.surfaceVoxels);
  f("cropBox", o.cropBox);
  f("slices", o.slices);
  f("orientation", o.orientation);
  f("oblique", o.oblique);
  f("measures", o.measures);
  f("linkedZoom", o.linkedZoom);
  f("classifiedTint", o.classifiedTint);
  f("slicePoints", o.slicePoints);
  f("meshContour", o.meshContour);
  f("crossHairInSpace", o.crossHairInSpace);
  f("content", o.content);
  f("volumeStyle", o.volumeStyle);
  f("volumeLayer", o.volumeLayer);
  f("comparedStyle", o.comparedStyle);
  f("crop", o.crop);
  f("meshStyle", o.meshStyle);
  f("unmeasured", o.unmeasured);
  f("parts", o.parts);
  f("volumeLevel", o.volumeLevel, Range{0.0, 1.0});
  f("volume", o.volume);
  f("clip", o.clip);
  f("skin", o.skin);
  f("camera", o.camera);
  f("brushRadius", o.brushRadius, Range{kLeastBrush, kMostBrush});
  f("lassoDepth", o.lassoDepth, Range{0.0, 1000.0});
  f("maximised", o.maximised);
}

}  // namespace sonoskin
