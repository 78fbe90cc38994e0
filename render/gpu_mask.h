#pragma once

#include <cstdint>
#include <vector>

#include "core/base/hash.h"
#include "core/volume/volume.h"
#include "render/gl/texture.h"

namespace sonoskin {

// GpuMask: a mask's copy on the GPU, for one that is painted: only the slices across k that have changed are uploaded.
class GpuMask {
 public:
  // set: `key` names the mask's content; nothing is done where it is the same as the last time.
  //   cost  reads all of a changed mask: 2 ms for 467x255x124
  void set(const Volume<std::uint8_t>& mask, const Key& key);

  const gl::Texture& texture() const { return texture_; }
  const Geometry& geometry() const { return geometry_; }
  explicit operator bool() const { return bool(texture_); }

 private:
  gl::Texture texture_;
  Geometry geometry_;
  Key key_;
  std::vector<Key> slices_;
};

}  // namespace sonoskin
