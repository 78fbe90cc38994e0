#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>

#include "core/io/image.h"

namespace sonoskin {

// PictureText: writes words into pictures, without OpenGL, in the window's font where it is installed.
//   threads  one at a time
class PictureText {
 public:
  //   pixels  height of the letters' line
  explicit PictureText(int pixels);
  ~PictureText();
  PictureText(const PictureText&) = delete;
  PictureText& operator=(const PictureText&) = delete;

  // canWrite: whether there is a font; nothing is written without one.
  bool canWrite() const;
  // width: of a text, pixels. What follows an underscore, up to the next space, is an index: smaller and lower.
  int width(const std::string& text) const;
  // write: from the place where the text's line begins, at its base.
  //   colour  sRGB
  void write(Image& image, const std::string& text, glm::ivec2 place,
             const std::array<std::uint8_t, 3>& colour) const;

 private:
  struct Faces;
  std::unique_ptr<Faces> faces_;
};

}  // namespace sonoskin
