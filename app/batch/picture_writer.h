#pragma once

#include <filesystem>
#include <future>
#include <vector>

#include "core/io/image.h"

namespace sonoskin {

// PictureWriter: packs and writes pictures on threads of their own while others are drawn. What goes away waits for them.
class PictureWriter {
 public:
  void write(std::filesystem::path path, Image picture);
  // finish: waits until all are written.
  //   errors  as writePng
  void finish();

 private:
  std::vector<std::future<void>> writing_;
};

}  // namespace sonoskin
