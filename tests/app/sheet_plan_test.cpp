// What the contact sheet's dialog proposes and asks for.
#include "app/panels/sheet_plan.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"

namespace sonoskin::ui {
namespace {

const SheetNumber& numberNamed(const std::vector<SheetNumber>& numbers, const std::string& name) {
  return *std::ranges::find(numbers, name, &SheetNumber::name);
}

TEST(SheetPlan, ThePresentValueIsInTheMiddle) {
  Parameters parameters;
  parameters.classification.beta = 1.3;
  parameters.classification.alpha = 0.7;
  const auto numbers = sheetNumbers(parameters, {});
  EXPECT_EQ(numbers.front().title, "β   classification.beta");
  for (const char* name : {"classification.beta", "classification.alpha", "mesh.resolution"}) {
    const SheetNumber& number = numberNamed(numbers, name);
    const SheetAxis axis = axisOf(number, usualRange(number), parameters);
    ASSERT_EQ(axis.values.size(), 5u) << name;
    ASSERT_TRUE(axis.current) << name;
    EXPECT_EQ(*axis.current, 2u) << name;
    EXPECT_DOUBLE_EQ(std::stod(axis.values[2]), number.value) << name;
  }
  const SheetNumber& alpha = numberNamed(numbers, "classification.alpha");
  EXPECT_DOUBLE_EQ(usualRange(alpha).from, 0.35);
  EXPECT_DOUBLE_EQ(usualRange(alpha).to, 1.4) << "equal ways are factors";
}

// An iso-value that is found from the scan goes over values around the one that was found.
TEST(SheetPlan, AFoundIsoValueIsTheOneThatWasFound) {
  Results results;
  results.isoValue = 0.3251;
  const auto numbers = sheetNumbers({}, results);
  const SheetNumber& iso = numberNamed(numbers, "classification.isoValue");
  EXPECT_DOUBLE_EQ(iso.value, 0.325);
  const SheetAxis axis = axisOf(iso, usualRange(iso), {});
  EXPECT_EQ(axis.values[*axis.current], "0.325");
}

TEST(SheetPlan, ValuesStayWithinTheParametersRange) {
  const auto numbers = sheetNumbers({}, {});
  for (const SheetNumber& number : numbers) {
    const SheetAxis axis = axisOf(number, usualRange(number), {});  // refuses what lies outside
    EXPECT_GE(axis.values.size(), 1u) << number.name;
  }
}

TEST(SheetPlan, WhatTheCellsShowIsSaidInWordsOfTheCommandLine) {
  SheetPlan plan = usualPlan(sheetNumbers({}, {}));
  plan.plane = Plane::coronal;
  const ScanView slice = sheetView(plan, {1.23456, -2, 3});
  EXPECT_EQ(slice.view + slice.layer + slice.plane, "sliceclassifiedcoronal");
  EXPECT_EQ(slice.at, glm::dvec3(1.23, -2, 3));
  plan.picture = SheetPicture::volume;
  const ScanView volume = sheetView(plan, {});
  EXPECT_EQ(volume.view + volume.layer + volume.volume.mode, "volumeclassifiediso");
}

}  // namespace
}  // namespace sonoskin::ui
