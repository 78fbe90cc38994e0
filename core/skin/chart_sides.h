#pragma once

#include <span>
#include <vector>

#include "core/skin/atlas_reading.h"
#include "core/skin/skin_surface.h"

namespace sonoskin {

// ChartSides: places every half texel along the sides of an atlas' charts. A look between texels there also meets texels
// beyond the side, which show the surface from another chart's view or not at all, and where the surface is creased both
// charts of a seam find another light. They show the same once the texels around the side are fitted to what is right
// on it.
class ChartSides {
 public:
  // input   surface   in charts; in blocks every side would be one, and none are taken
  explicit ChartSides(const SkinSurface& surface);

  // Place: a point of a side, by its triangle and the weights of its corners.
  //   look    what is read there; texels that show nothing have no share
  //   steps   what each texel takes on of what the look lacks
  struct Place {
    std::uint32_t triangle;
    glm::vec3 weights;
    AtlasLook look;
    glm::vec4 steps;
  };
  const std::vector<Place>& places() const { return places_; }

  // fit: changes the texels around the sides until looks find the light there; those beyond the sides much more than those
  // that the chart owns.
  //   method   a few rounds of projection on one place after the other          [Kaczmarz 1937; damped, weighted by texel]
  //   input    light   per place, not below 0
  //            map     per texel; 0 where nothing is shown
  void fit(std::span<const glm::vec4> light, std::vector<glm::vec4>& map) const;

  std::size_t bytes() const { return places_.size() * sizeof(Place); }

 private:
  void add(const SkinSurface& surface, std::uint32_t triangle, const glm::vec3& weights);

  std::vector<Place> places_;
};

}  // namespace sonoskin
