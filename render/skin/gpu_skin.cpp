#include "render/skin/gpu_skin.h"

#include <glad/gl.h>

#include <algorithm>
#include <atomic>
#include <span>

namespace sonoskin {
namespace {

template <class T>
std::vector<T> gather(const std::vector<T>& values, const std::vector<std::uint32_t>& source) {
  std::vector<T> gathered(source.size());
  for (std::size_t i = 0; i < source.size(); ++i) gathered[i] = values[source[i]];
  return gathered;
}

template <class T>
gl::Texture texture(glm::ivec2 size, gl::Format format, gl::Filter filter, const std::vector<T>& texels) {
  gl::Texture made({.size = glm::ivec3(size, 0), .format = format, .filter = filter});
  made.upload(texels.data());
  return made;
}

// Tiles: which tiles of an atlas are drawn.
class Tiles {
 public:
  explicit Tiles(glm::ivec2 size)
      : size_(size),
        count_((size + kTile - 1) / kTile),
        drawn_(std::size_t(count_.x) * std::size_t(count_.y)) {}

  // draw: those with texels from `low` to `high`, both of them included.
  void draw(glm::ivec2 low, glm::ivec2 high) {
    low = glm::clamp(low, glm::ivec2(0), size_ - 1) / kTile;
    high = glm::clamp(high, glm::ivec2(0), size_ - 1) / kTile;
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) drawn_[index(x, y)] = true;
  }
  // triangles: each row's runs as two triangles; 0 to 1 over the atlas.
  std::vector<glm::vec2> triangles() const {
    std::vector<glm::vec2> corners;
    for (int y = 0; y < count_.y; ++y)
      for (int x = 0; x < count_.x; ++x) {
        if (!drawn_[index(x, y)]) continue;
        const int first = x;
        while (x + 1 < count_.x && drawn_[index(x + 1, y)]) ++x;
        const auto place = [&](int i, int j) {
          return glm::vec2(glm::min(glm::ivec2(i, j) * kTile, size_)) / glm::vec2(size_);
        };
        const glm::vec2 low = place(first, y), high = place(x + 1, y + 1), right(high.x, low.y),
                        left(low.x, high.y);
        corners.insert(corners.end(), {low, right, high, low, high, left});
      }
    return corners;
  }

 private:
  static constexpr int kTile = 8;  // texels
  std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(count_.x) + std::size_t(x); }

  glm::ivec2 size_, count_;
  std::vector<bool> drawn_;
};

std::vector<glm::vec2> coveredTiles(const AtlasMaps& maps) {
  Tiles tiles(maps.size);
  for (int y = 0; y < maps.size.y; ++y)
    for (int x = 0; x < maps.size.x; ++x)
      if (maps.position[std::size_t(y) * std::size_t(maps.size.x) + std::size_t(x)].w > 0)
        tiles.draw({x, y}, {x, y});
  return tiles.triangles();
}

// What looks between texels touch on the triangles that are shown; not on their charts' skirts.
std::vector<glm::vec2> shownTiles(const Atlas& atlas, std::size_t shown) {
  Tiles tiles(atlas.size);
  for (const auto& [a, b, c] : std::span(atlas.corners).first(std::min(shown, atlas.corners.size())))
    tiles.draw(glm::ivec2(glm::floor(glm::min(a, glm::min(b, c)) - 0.5f)),
               glm::ivec2(glm::floor(glm::max(a, glm::max(b, c)) + 0.5f)));
  return tiles.triangles();
}

}  // namespace

GpuSkin::GpuSkin() : parts_(std::make_unique<Parts>()) {}
GpuSkin::~GpuSkin() = default;
GpuSkin::GpuSkin(GpuSkin&&) noexcept = default;
GpuSkin& GpuSkin::operator=(GpuSkin&&) noexcept = default;

const std::shared_ptr<const SkinSurface>& GpuSkin::surface() const { return parts_->surface; }
const Box& GpuSkin::box() const { return parts_->box; }

void GpuSkin::set(std::shared_ptr<const SkinSurface> surface) {
  if (surface == parts_->surface) return;
  *parts_ = Parts();  // two would need twice the memory
  static std::atomic<std::uint64_t> surfaces{0};
  parts_->number = ++surfaces;
  parts_->surface = std::move(surface);
  try {
    parts_->upload();
  } catch (...) {
    *parts_ = Parts();
    throw;
  }
}

void GpuSkin::giveBackSky() {
  for (gl::Texture* map : {&parts_->open, &parts_->stretch}) *map = gl::Texture();
}

void GpuSkin::giveBackMaps() {
  for (gl::Texture* map : {&parts_->position, &parts_->normal, &parts_->open, &parts_->stretch})
    *map = gl::Texture();
}

void GpuSkin::Parts::upload() {
  vertexArray.reset();
  covered.array.reset();
  shown.array.reset();
  box = {};
  if (!surface) return;
  const Mesh& mesh = *surface->mesh;
  const auto& source = surface->vertices.source;
  uploadHidden();
  box = boundingBox(mesh.positions);
  if (hides()) {
    const Box rest = boundingBox(surface->hidden.positions);
    box = {glm::min(box.min, rest.min), glm::max(box.max, rest.max)};
  }
  positions = gl::Buffer(std::span<const glm::vec3>(gather(mesh.positions, source)));
  normals = gl::Buffer(std::span<const glm::vec3>(gather(mesh.normals, source)));
  uvs = gl::Buffer(std::span<const glm::vec2>(surface->vertices.uv));
  indices = gl::Buffer(std::span<const Triangle>(surface->vertices.triangles));
  vertexArray.emplace();
  vertexArray->attribute(0, 3, positions);
  vertexArray->attribute(1, 3, normals);
  vertexArray->attribute(2, 2, uvs);
  if (!mesh.measured.empty()) {
    measured = gl::Buffer(std::span<const float>(gather(mesh.measured, source)));
    vertexArray->attribute(3, 1, measured);
  }
  vertexArray->indices(indices);
  const AtlasMaps& maps = surface->maps;
  covered.upload(coveredTiles(maps));
  shown.upload(shownTiles(surface->atlas, surface->shown));
  position = texture(maps.size, gl::Format::rgba32f, gl::Filter::nearest, maps.position);
  normal = texture(maps.size, gl::Format::rgba16f, gl::Filter::linear, maps.normal);
  open = texture(maps.size, gl::Format::rgba16f, gl::Filter::linear, maps.occlusion);
  stretch = texture(maps.size, gl::Format::rg16f, gl::Filter::nearest, maps.stretch);
}

void GpuSkin::Parts::uploadHidden() {
  hidden = {};
  if (!hides()) return;
  const Mesh& mesh = surface->hidden;
  hidden.positions = gl::Buffer(std::span<const glm::vec3>(mesh.positions));
  hidden.normals = gl::Buffer(std::span<const glm::vec3>(mesh.normals));
  hidden.indices = gl::Buffer(std::span<const Triangle>(mesh.triangles));
  hidden.array.emplace();
  hidden.array->attribute(0, 3, hidden.positions);
  hidden.array->attribute(1, 3, hidden.normals);
  hidden.array->indices(hidden.indices);
}

void GpuSkin::Parts::drawHidden() const {
  if (!hides()) return;
  glBindVertexArray(hidden.array->name());
  glDrawElements(GL_TRIANGLES, GLsizei(surface->hidden.triangles.size() * 3), GL_UNSIGNED_INT, nullptr);
}

void GpuSkin::Parts::draw() const { drawFirst(std::min(surface->shown, surface->vertices.triangles.size())); }

void GpuSkin::Parts::drawAll() const { drawFirst(surface->vertices.triangles.size()); }

void GpuSkin::Parts::drawFirst(std::size_t triangles) const {
  glBindVertexArray(vertexArray->name());
  glVertexAttrib1f(3, 1.0f);  // for meshes that do not say what was measured
  glDrawElements(GL_TRIANGLES, GLsizei(triangles * 3), GL_UNSIGNED_INT, nullptr);
}

void GpuSkin::Parts::Drawn::upload(const std::vector<glm::vec2>& places) {
  corners = gl::Buffer(std::span<const glm::vec2>(places));
  vertices = int(places.size());
  array.emplace();
  array->attribute(0, 2, corners);
}

void GpuSkin::Parts::Drawn::draw() const {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glBindVertexArray(array->name());
  glDrawArrays(GL_TRIANGLES, 0, vertices);
}

std::size_t GpuSkin::Parts::bytes() const {
  if (!surface) return 0;
  const std::size_t perTexel = position ? 16 + 8 + 8 + 4 : 0;
  return std::size_t(surface->maps.size.x) * std::size_t(surface->maps.size.y) * perTexel +
         positions.bytes() + normals.bytes() + uvs.bytes() + indices.bytes() + hidden.positions.bytes() +
         hidden.normals.bytes() + hidden.indices.bytes();
}

gl::Texture chartNumbers(const SkinSurface& surface) {
  const glm::ivec2 size = surface.maps.size;
  std::vector<float> number(std::size_t(size.x) * std::size_t(size.y), 0.f);
  for (std::size_t t = 0; t < surface.atlas.corners.size(); ++t) {
    const Corners& c = surface.atlas.corners[t];
    const glm::ivec2 low(glm::floor(glm::min(c[0], glm::min(c[1], c[2])))),
        high(glm::ceil(glm::max(c[0], glm::max(c[1], c[2]))));
    for (int y = std::max(low.y, 0); y < std::min(high.y + 1, size.y); ++y)
      for (int x = std::max(low.x, 0); x < std::min(high.x + 1, size.x); ++x)
        number[std::size_t(y) * std::size_t(size.x) + std::size_t(x)] = float(surface.atlas.chart[t] + 1);
  }
  return texture(size, gl::Format::r32f, gl::Filter::nearest, number);
}

}  // namespace sonoskin
