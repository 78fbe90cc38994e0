#include "render/gpu_mask.h"

#include <span>

namespace sonoskin {

void GpuMask::set(const Volume<std::uint8_t>& mask, const Key& key) {
  const glm::ivec3 dims = mask.geometry.dims;
  geometry_ = mask.geometry;
  if (texture_ && key_ == key && texture_.size() == dims) return;
  if (!texture_ || texture_.size() != dims) {
    texture_ = gl::Texture({.size = dims, .format = gl::Format::r8});
    slices_.assign(std::size_t(dims.z), Key{});
  }
  const std::size_t size = mask.geometry.index(0, 0, 1);
  for (int k = 0; k < dims.z; ++k) {
    const std::uint8_t* slice = &mask.at(0, 0, k);
    const Key content = Hasher("slice").add(std::span(slice, size)).key();
    if (content == slices_[std::size_t(k)]) continue;
    texture_.uploadSlices(k, 1, slice);
    slices_[std::size_t(k)] = content;
  }
  key_ = key;
}

}  // namespace sonoskin
