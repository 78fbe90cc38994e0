#include "core/skin/skin_presets.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/base/error.h"
#include "core/skin/skin_material.h"

namespace sonoskin {
namespace {

struct Look {
  SkinOptions skin;
  LightOptions light;
};

Look applied(const SkinPreset& preset) {
  Look look;
  applySkinPreset(preset, look.skin, look.light);
  return look;
}

// A visitor of fields() that asks whether every number lies in its range.
struct InRange {
  template <class T, class N>
  void operator()(const Field& field, const T& value, const Range<N>& range) const {
    EXPECT_TRUE(value >= range.min && value <= range.max) << field.name;
  }
  template <class N>
  void operator()(const Field& field, const std::array<N, 3>& values, const Range<N>& range) const {
    for (N value : values) (*this)(field, value, range);
  }
  template <class T>
  void operator()(const Field&, const T&) const {}
};

TEST(SkinPresets, HaveNamesSentencesAndAllowedValues) {
  std::set<std::string_view> names;
  for (const SkinPreset& preset : skinPresets()) {
    EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
    EXPECT_EQ(preset.name.find(' '), std::string_view::npos) << "a word on the command line";
    EXPECT_FALSE(preset.help.empty());
    EXPECT_NE(preset.help.back(), '.');
    const Look look = applied(preset);
    fields(InRange{}, look.skin);
    fields(InRange{}, look.light);
  }
}

TEST(SkinPresets, TheFirstIsTheDefault) {
  EXPECT_EQ(skinPresets()[0].name, "newborn");
  const Look look = applied(skinPresets()[0]);
  EXPECT_EQ(look.skin, SkinOptions{});
  EXPECT_EQ(look.light, LightOptions{});
}

TEST(SkinPresets, ReplaceOneAnotherAndAreKnownByTheirValues) {
  for (const SkinPreset& preset : skinPresets()) {
    Look look = applied(findSkinPreset("marble"));
    look.light.azimuth = 77;
    applySkinPreset(preset, look.skin, look.light);
    ASSERT_NE(matchingSkinPreset(look.skin, look.light), nullptr);
    EXPECT_EQ(matchingSkinPreset(look.skin, look.light)->name, preset.name);
    look.light.exposure += 0.125;
    EXPECT_EQ(matchingSkinPreset(look.skin, look.light), nullptr);
  }
}

TEST(SkinPresets, EachHasAMaterial) {
  for (const SkinPreset& preset : skinPresets())
    EXPECT_EQ(makeSkinMaterial(applied(preset).skin).transmittance.size(), size_t(SkinMaterial::kSteps))
        << preset.name;
}

TEST(SkinPresets, AnUnknownOneIsRefusedWithTheNamesOfAll) {
  try {
    findSkinPreset("handsome");
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::usage);
    for (const SkinPreset& preset : skinPresets())
      EXPECT_NE(std::string(error.what()).find(preset.name), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace sonoskin
