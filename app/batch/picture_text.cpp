#include "app/batch/picture_text.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <functional>

#include "app/widgets/font_files.h"

namespace sonoskin {
namespace {

constexpr float kIndexSize = 0.76f, kIndexDrop = 0.18f;  // of the text's size

// codePoints: of UTF-8; what is none is left out.
std::u32string codePoints(const std::string& text) {
  std::u32string points;
  for (std::size_t n = 0; n < text.size();) {
    const auto first = static_cast<unsigned char>(text[n++]);
    const int more = first < 0x80 ? 0 : first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : -1;
    if (more < 0 || n + std::size_t(more) > text.size()) continue;
    char32_t point = more == 0 ? first : first & (0x3Fu >> more);
    for (int k = 0; k < more; ++k) point = (point << 6) | (static_cast<unsigned char>(text[n++]) & 0x3Fu);
    points.push_back(point);
  }
  return points;
}

void blend(Image& image, glm::ivec2 at, const std::array<std::uint8_t, 3>& colour, int coverage) {
  if (at.x < 0 || at.y < 0 || at.x >= image.width || at.y >= image.height) return;
  std::uint8_t* pixel = &image.rgba[4 * (std::size_t(at.y) * std::size_t(image.width) + std::size_t(at.x))];
  for (std::size_t c = 0; c < 3; ++c)
    pixel[c] = std::uint8_t((pixel[c] * (255 - coverage) + colour[c] * coverage + 127) / 255);
}

}  // namespace

// Faces: the font, and the one for letters that it lacks.
struct PictureText::Faces {
  FT_Library library = nullptr;
  FT_Face text = nullptr, fallback = nullptr;
  int pixels;

  explicit Faces(int size) : pixels(size) {
    if (FT_Init_FreeType(&library) != 0) return;
    const FontFiles files = findFontFiles(FontStyle::regular);
    if (!files.text.empty() && FT_New_Face(library, files.text.c_str(), 0, &text) != 0) text = nullptr;
    if (!files.fallback.empty() && FT_New_Face(library, files.fallback.c_str(), 0, &fallback) != 0)
      fallback = nullptr;
  }
  ~Faces() {
    if (library) FT_Done_FreeType(library);  // and the faces with it
  }

  // glyph: rendered, with the size of text or index; null where no font has the letter.
  FT_GlyphSlot glyph(char32_t point, bool index) const {
    for (const FT_Face face : {text, fallback}) {
      if (!face || FT_Get_Char_Index(face, point) == 0) continue;
      FT_Set_Pixel_Sizes(face, 0, FT_UInt(index ? kIndexSize * float(pixels) : float(pixels)));
      if (FT_Load_Char(face, point, FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT) == 0) return face->glyph;
    }
    return nullptr;
  }

  // walk: visits the glyphs with the place of each, relative to the beginning; how far it gets.
  int walk(const std::string& words, const std::function<void(FT_GlyphSlot, glm::ivec2)>& visit) const {
    int x = 0;
    bool index = false;
    for (const char32_t point : codePoints(words)) {
      if (point == U'_' || (index && point == U' ')) index = point == U'_';
      if (point == U'_') continue;
      const FT_GlyphSlot slot = glyph(point, index);
      if (!slot) continue;
      if (visit) visit(slot, {x, index ? int(kIndexDrop * float(pixels) + 0.5f) : 0});
      x += int((slot->advance.x + 32) >> 6);
    }
    return x;
  }
};

PictureText::PictureText(int pixels) : faces_(std::make_unique<Faces>(pixels)) {}
PictureText::~PictureText() = default;

bool PictureText::canWrite() const { return faces_->text != nullptr; }

int PictureText::width(const std::string& text) const { return faces_->walk(text, {}); }

void PictureText::write(Image& image, const std::string& text, glm::ivec2 place,
                        const std::array<std::uint8_t, 3>& colour) const {
  faces_->walk(text, [&](FT_GlyphSlot slot, glm::ivec2 offset) {
    const FT_Bitmap& bitmap = slot->bitmap;
    const glm::ivec2 corner = place + offset + glm::ivec2(slot->bitmap_left, -slot->bitmap_top);
    for (int y = 0; y < int(bitmap.rows); ++y)
      for (int x = 0; x < int(bitmap.width); ++x)
        blend(image, corner + glm::ivec2(x, y), colour, bitmap.buffer[y * bitmap.pitch + x]);
  });
}

}  // namespace sonoskin
