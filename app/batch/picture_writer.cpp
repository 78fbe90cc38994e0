#include "app/batch/picture_writer.h"

#include <utility>

namespace sonoskin {

void PictureWriter::write(std::filesystem::path path, Image picture) {
  writing_.push_back(std::async(std::launch::async, [path = std::move(path), picture = std::move(picture)] {
    writePng(path, picture);
  }));
}

void PictureWriter::finish() {
  for (std::future<void>& one : writing_) one.get();
  writing_.clear();
}

}  // namespace sonoskin
