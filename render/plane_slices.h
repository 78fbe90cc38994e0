#pragma once

#include <cstdint>
#include <memory>

#include "core/volume/volume.h"

namespace sonoskin {

// slicesAround: the part of a volume that a plane's picture is interpolated from: one or two slices across an axis of the
// volume, where they are in the world; of a plane outside of the volume its outermost ones. Null of a null volume.
//   across  0: i, 1: j, 2: k
//   point   world mm, on the plane
std::shared_ptr<const Volume<float>> slicesAround(const std::shared_ptr<const Volume<float>>& volume,
                                                  int across, const glm::dvec3& point);
std::shared_ptr<const Volume<std::uint8_t>> slicesAround(
    const std::shared_ptr<const Volume<std::uint8_t>>& volume, int across, const glm::dvec3& point);

}  // namespace sonoskin
