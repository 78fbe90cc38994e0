#include "core/mesh/atlas/atlas_stretch.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel_blocks.h"

namespace sonoskin {
namespace {

// Slopes: the change of the position from one texel to the next, mm. w: 1 where it is known.
struct Slopes {
  std::vector<glm::vec4> alongU, alongV;
};

// By central differences, at the ends of a chart by one-sided ones.
glm::vec4 slope(const glm::vec4& here, const glm::vec4* before, const glm::vec4* after) {
  if (here.w == 0) return glm::vec4(0);
  const bool hasBefore = before && before->w > 0, hasAfter = after && after->w > 0;
  if (!hasBefore && !hasAfter) return glm::vec4(0);
  const glm::vec3 from(hasBefore ? *before : here), to(hasAfter ? *after : here);
  return glm::vec4((to - from) * (hasBefore && hasAfter ? 0.5f : 1.f), 1);
}

Slopes slopesOf(const glm::ivec2& size, const std::vector<glm::vec4>& position, const Progress& progress) {
  Slopes slopes{std::vector<glm::vec4>(position.size()), std::vector<glm::vec4>(position.size())};
  parallelFor(
      size.y,
      [&](std::ptrdiff_t y) {
        const std::size_t row = std::size_t(y) * std::size_t(size.x), width = std::size_t(size.x);
        for (std::size_t x = 0; x < width; ++x) {
          const glm::vec4* p = &position[row + x];
          slopes.alongU[row + x] = slope(*p, x > 0 ? p - 1 : nullptr, x + 1 < width ? p + 1 : nullptr);
          slopes.alongV[row + x] =
              slope(*p, y > 0 ? p - width : nullptr, y + 1 < size.y ? p + width : nullptr);
        }
      },
      progress);
  return slopes;
}

// Blurs a line of `count` values with the weights 1, 2, ..., n, ..., 2, 1 by two moving sums, each over runs of values
// with w > 0 only: a gap is as good as an end. w becomes 1 in runs.
class LineBlur {
 public:
  explicit LineBlur(int halfWidth) : half_(halfWidth) {}

  void blur(std::vector<glm::vec4>& line) {
    for (std::size_t begin = 0; begin < line.size();) {
      if (line[begin].w == 0) {
        ++begin;
        continue;
      }
      std::size_t end = begin;
      while (end < line.size() && line[end].w > 0) ++end;
      for (int pass = 0; pass < 2; ++pass) average(line, std::ptrdiff_t(begin), std::ptrdiff_t(end));
      begin = end;
    }
  }

 private:
  void average(std::vector<glm::vec4>& line, std::ptrdiff_t begin, std::ptrdiff_t end) {
    sums_.assign(1, glm::dvec4(0));
    for (std::ptrdiff_t i = begin; i < end; ++i)
      sums_.push_back(sums_.back() + glm::dvec4(line[std::size_t(i)]));
    for (std::ptrdiff_t i = begin; i < end; ++i) {
      const std::ptrdiff_t first = std::max(i - half_, begin), last = std::min(i + half_ + 1, end);
      const glm::dvec4 sum = sums_[std::size_t(last - begin)] - sums_[std::size_t(first - begin)];
      line[std::size_t(i)] = glm::vec4(glm::vec3(sum) / float(sum.w), 1);
    }
  }

  std::ptrdiff_t half_;
  std::vector<glm::dvec4> sums_;
};

void blurRows(const glm::ivec2& size, int halfWidth, std::vector<glm::vec4>& map, const Progress& progress) {
  const std::ptrdiff_t width = size.x;
  parallelFor(
      size.y,
      [&](std::ptrdiff_t y) {
        LineBlur lineBlur(halfWidth);
        std::vector<glm::vec4> line(map.begin() + y * width, map.begin() + (y + 1) * width);
        lineBlur.blur(line);
        std::copy(line.begin(), line.end(), map.begin() + y * width);
      },
      progress);
}

// Eight columns at a time, so that what a cache line holds is used.
void blurColumns(const glm::ivec2& size, int halfWidth, std::vector<glm::vec4>& map,
                 const Progress& progress) {
  constexpr std::size_t kColumns = 8;
  const auto at = [&](int x, int y) -> glm::vec4& {
    return map[std::size_t(y) * std::size_t(size.x) + std::size_t(x)];
  };
  parallelBlocks(
      std::size_t(size.x), kColumns,
      [&](std::size_t first, std::size_t end) {
        const int x0 = int(first), x1 = int(end);
        LineBlur lineBlur(halfWidth);
        std::array<std::vector<glm::vec4>, kColumns> lines;
        for (auto& line : lines) line.resize(std::size_t(size.y));
        for (int y = 0; y < size.y; ++y)
          for (int x = x0; x < x1; ++x) lines[std::size_t(x - x0)][std::size_t(y)] = at(x, y);
        for (auto& line : lines) lineBlur.blur(line);
        for (int y = 0; y < size.y; ++y)
          for (int x = x0; x < x1; ++x) at(x, y) = lines[std::size_t(x - x0)][std::size_t(y)];
      },
      progress);
}

// The mean over what is owned, mm per texel.
float meanStretch(const std::vector<glm::vec4>& position, const Slopes& slopes, float texel) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < position.size(); ++i) {
    if (position[i].w < 1 || slopes.alongU[i].w == 0 || slopes.alongV[i].w == 0) continue;
    sum += std::sqrt(double(glm::length(glm::vec3(slopes.alongU[i]))) *
                     double(glm::length(glm::vec3(slopes.alongV[i]))));
    ++count;
  }
  return count > 0 && sum > 0 ? float(sum / count) : texel;
}

// Within [0.2, 5] times the mean, and neither more than twice the other with the same area.
glm::vec2 limited(const glm::vec4& alongU, const glm::vec4& alongV, float mean) {
  glm::vec2 s(alongU.w > 0 ? glm::length(glm::vec3(alongU)) : mean,
              alongV.w > 0 ? glm::length(glm::vec3(alongV)) : mean);
  s = glm::clamp(s, 0.2f * mean, 5.f * mean);
  const float side = std::sqrt(s.x * s.y),
              ratio = std::clamp(std::sqrt(s.x / s.y), std::sqrt(0.5f), std::sqrt(2.f));
  return {side * ratio, side / ratio};
}

}  // namespace

std::vector<glm::vec2> stretchMap(const Atlas& atlas, const std::vector<glm::vec4>& position,
                                  const Progress& progress) {
  constexpr float kLength = 0.5f;  // mm of a body
  const glm::ivec2 size = atlas.size;
  const float texel = atlas.texel;
  Slopes slopes = slopesOf(size, position, progress.part(0, 0.2));
  // Two moving means of 2 h + 1 values have the variance 2 h (h + 1) / 3.
  const float sigma = kLength * atlas.unit / texel;
  const int half = std::max(1, int(std::lround(0.5 * (std::sqrt(1 + 6 * sigma * sigma) - 1))));
  double done = 0.2;
  for (std::vector<glm::vec4>* map : {&slopes.alongU, &slopes.alongV}) {
    blurRows(size, half, *map, progress.part(done, done + 0.2));
    blurColumns(size, half, *map, progress.part(done + 0.2, done + 0.35));
    done += 0.35;
  }
  const float mean = meanStretch(position, slopes, texel);
  std::vector<glm::vec2> stretch(position.size(), glm::vec2(texel));
  parallelFor(
      size.y,
      [&](std::ptrdiff_t y) {
        const std::size_t row = std::size_t(y) * std::size_t(size.x);
        for (std::size_t i = row; i < row + std::size_t(size.x); ++i)
          if (position[i].w > 0) stretch[i] = limited(slopes.alongU[i], slopes.alongV[i], mean);
      },
      progress.part(0.9, 1));
  return stretch;
}

}  // namespace sonoskin
