#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/rbf/compact/local_quadric.h"

namespace sonoskin {

// Centre: one support of the implicit function.
struct Centre {
  glm::vec3 position{0};  // c, mm
  float support = 1;      // σ, mm
  GlobalQuadric quadric;  // g
  float lambda = 0;       // λ, mm
};

// CentreIndex: centres by the cells of a coarse grid that their supports touch.
//   cost   O(sum of touched cells) to build; a query is one look-up
class CentreIndex {
 public:
  CentreIndex() = default;
  // cell   edge, mm, > 0
  // pad    mm: a cell also lists centres whose supports come that near to it
  CentreIndex(std::vector<Centre> centres, float cell, float pad);

  // near: numbers of the centres whose supports may reach within `pad` of x, ascending; and perhaps some
  // more.
  std::span<const std::uint32_t> near(const glm::vec3& x) const;

  // entries: the lists of all cells, one after the other; near() gives a part of it.
  std::span<const std::uint32_t> entries() const { return list_; }

  const std::vector<Centre>& centres() const { return centres_; }
  std::size_t bytes() const {
    return centres_.size() * sizeof(Centre) + (start_.size() + list_.size()) * sizeof(std::uint32_t);
  }

 private:
  template <class F>
  void forEachCell(const Centre& centre, float pad, F&& f) const;

  std::vector<Centre> centres_;
  Box box_;
  float cell_ = 1;
  glm::ivec3 dims_{0};
  std::vector<std::uint32_t> start_, list_;
};

}  // namespace sonoskin
