// Whether texts can be read in either appearance, and colours told apart by whoever sees them.
#include "app/widgets/theme.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "app/widgets/field_equations.h"
#include "app/widgets/fields_ui.h"
#include "core/classification/classification_options.h"
#include "tests/support/imgui_test.h"

namespace sonoskin::ui {
namespace {

glm::dvec3 linear(const ImVec4& c) {
  const auto one = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  return {one(double(c.x)), one(double(c.y)), one(double(c.z))};
}

// [WCAG 2.1, contrast ratio]
double contrast(const ImVec4& a, const ImVec4& b) {
  const auto luminance = [](const ImVec4& c) {
    return glm::dot(linear(c), glm::dvec3(0.2126, 0.7152, 0.0722));
  };
  const double la = luminance(a) + 0.05, lb = luminance(b) + 0.05;
  return std::max(la, lb) / std::min(la, lb);
}

TEST(Theme, TextsCanBeReadInBothAppearances) {
  for (const Appearance appearance : {Appearance::dark, Appearance::light}) {
    const Colours& c = coloursOf(appearance);
    EXPECT_GE(contrast(c.text, c.ground), 10);
    for (const ImVec4& colour : {c.faintText, c.accent, c.good, c.warning, c.failure})
      EXPECT_GE(contrast(colour, c.ground), 4.5) << int(appearance);
  }
}

// What is seen without one kind of cones, linear RGB [Vienot, Brettel and Mollon 1999].
glm::dvec3 deuteranope(const glm::dvec3& c) {
  const double yellow = 0.29275 * c.r + 0.70725 * c.g;
  return {yellow, yellow, -0.02234 * c.r + 0.02234 * c.g + c.b};
}
glm::dvec3 protanope(const glm::dvec3& c) {
  const double yellow = 0.11238 * c.r + 0.88762 * c.g;
  return {yellow, yellow, 0.00401 * c.r - 0.00401 * c.g + c.b};
}

// CIE L*a*b*, D65.
glm::dvec3 lab(const glm::dvec3& c) {
  const double x = (0.4124 * c.r + 0.3576 * c.g + 0.1805 * c.b) / 0.9505,
               y = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b,
               z = (0.0193 * c.r + 0.1192 * c.g + 0.9505 * c.b) / 1.089;
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  return {116 * f(y) - 16, 500 * (f(x) - f(y)), 200 * (f(y) - f(z))};
}

TEST(Theme, TheColoursOfTheViewsCanBeToldApartByTheColourBlind) {
  const std::array views{kAxial, kSagittal, kCoronal, kSurface};
  for (std::size_t i = 0; i < views.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (const auto seen : {deuteranope, protanope})
        EXPECT_GT(glm::distance(lab(seen(linear(views[i]))), lab(seen(linear(views[j])))), 20)
            << i << " " << j;
}

class ThemeFonts : public ImGuiTest {
 protected:
  ThemeFonts() : ImGuiTest({100, 100}) {}
};

// Of the size that is told of a font, its em, a line of Inter has 1.21.
TEST_F(ThemeFonts, NoTextIsSmallerThanTwelvePixels) {
  EXPECT_GE(smallFont()->FontSize / 1.21f, 11.9f);
  EXPECT_EQ(unit(), 1);
  loadFonts(2);
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  EXPECT_EQ(unit(), 2);
}

// A letter that the fonts lack is a question mark.
TEST_F(ThemeFonts, EquationsAndSymbolsHaveTheirLetters) {
  ClassificationOptions options;
  fields(
      [&](const Field& field, auto&, auto...) {
        const std::string text = std::string(equationOf("classification." + std::string(field.name))) +
                                 greekSymbol(field.symbol) + "↺×⋯–";
        for (const char* at = text.c_str(); *at;) {
          unsigned int letter = 0;
          at += ImTextCharFromUtf8(&letter, at, text.c_str() + text.size());
          if (letter == '\n') continue;
          EXPECT_NE(ImGui::GetIO().Fonts->Fonts[0]->FindGlyphNoFallback(ImWchar(letter)), nullptr)
              << field.name << " U+" << std::hex << letter;
        }
      },
      options);
}

}  // namespace
}  // namespace sonoskin::ui
