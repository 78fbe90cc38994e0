// The picture of a contact sheet: its cells side by side, with labels.
#include <algorithm>
#include <cstring>

#include "app/batch/contact_sheet.h"
#include "app/batch/picture_text.h"
#include "core/base/log.h"

namespace sonoskin {
namespace {

using Colour = std::array<std::uint8_t, 3>;

constexpr Colour kGround{24, 26, 29}, kEmpty{38, 41, 45}, kLetters{222, 226, 230}, kMarked{237, 184, 89};
constexpr int kFrame = 4;  // pixels around the current cell

void fill(Image& image, glm::ivec2 from, glm::ivec2 size, const Colour& colour) {
  for (int y = std::max(from.y, 0); y < std::min(from.y + size.y, image.height); ++y)
    for (int x = std::max(from.x, 0); x < std::min(from.x + size.x, image.width); ++x) {
      std::uint8_t* pixel = &image.rgba[4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x))];
      std::copy(colour.begin(), colour.end(), pixel);
      pixel[3] = 255;
    }
}

void put(Image& image, const Image& picture, glm::ivec2 corner) {
  for (int y = 0; y < picture.height; ++y)
    std::memcpy(
        &image.rgba[4 * (std::size_t(corner.y + y) * std::size_t(image.width) + std::size_t(corner.x))],
        &picture.rgba[4 * std::size_t(y) * std::size_t(picture.width)], 4 * std::size_t(picture.width));
}

void writeCentred(Image& image, const PictureText& text, const std::string& words, glm::ivec2 middle,
                  const Colour& colour) {
  text.write(image, words, {middle.x - text.width(words) / 2, middle.y}, colour);
}

}  // namespace

Image pictureOfSheet(const ContactSheet& sheet) {
  const SheetLayout& layout = sheet.layout;
  const glm::ivec2 size = layout.size();
  Image image{size.x, size.y, std::vector<std::uint8_t>(4 * std::size_t(size.x) * std::size_t(size.y))};
  fill(image, {0, 0}, size, kGround);
  const PictureText text(layout.text);
  if (!text.canWrite())
    log(LogLevel::warning, "The sheet has no labels, for neither Inter nor DejaVu Sans is installed.");
  for (std::size_t n = 0; n < sheet.cells.size(); ++n) {
    const SheetCell& cell = sheet.cells[n];
    const glm::ivec2 corner = layout.corner(n);
    if (cell.current) fill(image, corner - kFrame, layout.cell + 2 * kFrame, kMarked);
    if (cell.failure.empty()) {
      put(image, cell.picture, corner);
    } else {
      fill(image, corner, layout.cell, kEmpty);
      writeCentred(image, text, "nothing found", corner + layout.cell / 2, kLetters);
    }
    writeCentred(image, text, cell.text,
                 corner + glm::ivec2(layout.cell.x / 2, layout.cell.y + 3 * layout.text / 2),
                 cell.current ? kMarked : kLetters);
  }
  return image;
}

}  // namespace sonoskin
