#pragma once

#include <glm/glm.hpp>
#include <nanoflann.hpp>
#include <vector>

namespace sonoskin::accuracy {

// PointTree: the nearest of some points.
class PointTree {
 public:
  explicit PointTree(const std::vector<glm::vec3>& points) : cloud_{points}, tree_(3, cloud_) {}

  // distance: to the nearest point; infinite if there is none.
  float distance(const glm::vec3& at) const {
    std::size_t index = 0;
    float squared = std::numeric_limits<float>::infinity();
    nanoflann::KNNResultSet<float> nearest(1);
    nearest.init(&index, &squared);
    if (!cloud_.points.empty()) tree_.findNeighbors(nearest, &at[0], nanoflann::SearchParams());
    return std::sqrt(squared);
  }

 private:
  struct Cloud {
    const std::vector<glm::vec3>& points;
    std::size_t kdtree_get_point_count() const { return points.size(); }
    float kdtree_get_pt(std::size_t point, std::size_t axis) const { return points[point][int(axis)]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
      return false;
    }
  };
  Cloud cloud_;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3> tree_;
};

}  // namespace sonoskin::accuracy
