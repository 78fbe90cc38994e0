#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/volume/volume.h"
#include "render/gl/texture.h"

namespace sonoskin {

// GpuVolume: a volume's copy on the GPU; each of its textures is made when it is first asked for, and again only where the
// volume is another object than the last time. Values are taken as 0 to 1; those of byte volumes are divided by 255.
class GpuVolume {
 public:
  static constexpr int kBrick = 8;  // voxels along a brick's side

  // set: keeps the volume alive, so that its address stays its name.
  void set(std::shared_ptr<const Volume<float>> volume);
  void set(std::shared_ptr<const Volume<std::uint8_t>> volume);

  bool empty() const { return !floats_ && !bytes_; }
  // number: of the volume that was set, in the order of all that ever were; names of textures and addresses come back.
  std::uint64_t number() const { return number_; }
  const Geometry& geometry() const { return geometry_; }
  // The volume that was set: one of them is null.
  const std::shared_ptr<const Volume<float>>& floats() const { return floats_; }
  const std::shared_ptr<const Volume<std::uint8_t>>& bytes() const { return bytes_; }

  // The textures.
  //   errors  Error (system): the driver cannot hold it
  // values: one 8-bit number per voxel where that is exact, else 16-bit.
  const gl::Texture& values() const;
  // prepare: makes some of the values, and of the bricks where they are wanted, so that a frame that shows them first need
  // not make all.
  //   seconds  that it may take, about
  //   output   whether all is there
  bool prepare(double seconds, bool withBricks);
  // contentBox: world mm, around the bricks that hold a value above `threshold`; around all of them if none does.
  Box contentBox(float threshold);
  // bricks: for every 8^3 voxels the largest value that interpolation can give between their centres and the
  // next.
  const gl::Texture& bricks();
  // shades: xyz: gradient along i, j, k per mm times the smallest spacing times 4, from [-1, 1] to [0, 1]; w:
  // the value.
  const gl::Texture& shades();

 private:
  void begin(const Geometry& geometry);
  void uploadSome() const;

  std::shared_ptr<const Volume<float>> floats_;
  std::shared_ptr<const Volume<std::uint8_t>> bytes_;
  Geometry geometry_;
  std::uint64_t number_ = 0;
  std::vector<float> maxima_;   // of the bricks
  mutable gl::Texture values_;  // made by who only looks
  mutable int uploaded_ = 0;    // its slices that are there
  gl::Texture bricks_, shades_;
};

// brickMaxima: the largest value of every brick of side^3 cells (a cell spans a voxel's centre to the next).
//   output  ceil(dims / side) bricks along each axis, i fastest
std::vector<float> brickMaxima(const Volume<float>& volume, int side);

}  // namespace sonoskin
