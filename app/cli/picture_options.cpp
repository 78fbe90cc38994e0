#include "app/cli/picture_options.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace sonoskin {
namespace {

constexpr int kLeastSize = 16, kMostSize = 8192;

std::optional<glm::ivec2> parseSize(std::string_view text) {
  glm::ivec2 size{0};
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.x);
  if (width.ec != std::errc{} || width.ptr == end || *width.ptr != 'x') return std::nullopt;
  const auto height = std::from_chars(width.ptr + 1, end, size.y);
  if (height.ec != std::errc{} || height.ptr != end) return std::nullopt;
  if (glm::any(glm::lessThan(size, glm::ivec2(kLeastSize)))) return std::nullopt;
  if (glm::any(glm::greaterThan(size, glm::ivec2(kMostSize)))) return std::nullopt;
  return size;
}

}  // namespace

void addSizeOption(CLI::App& command, glm::ivec2& size) {
  auto store = [&size](const std::string& text) {
    const auto parsed = parseSize(text);
    if (!parsed) {
      throw Error(
          fmt::format(
              "--size {} is no size of a picture; give WIDTHxHEIGHT, {} to {} pixels each, such as {}x{}.",
              text, kLeastSize, kMostSize, size.x, size.y),
          Error::Kind::usage);
    }
    size = *parsed;
  };
  command
      .add_option_function<std::string>("--size", store,
                                        fmt::format("pixels of a picture [default {}x{}]", size.x, size.y))
      ->type_name("WxH");
}

void addBackendOption(CLI::App& command, gl::Backend& backend) {
  auto store = [&backend](const std::string& name) {
    if (name != "egl" && name != "osmesa")
      throw Error(fmt::format("--gl {} is not known; give egl or osmesa.", name), Error::Kind::usage);
    backend = name == "egl" ? gl::Backend::egl : gl::Backend::osmesa;
  };
  command
      .add_option_function<std::string>(
          "--gl", store,
          "where OpenGL comes from: egl (needs no display), osmesa (always software) [default egl]")
      ->type_name("egl|osmesa");
}

}  // namespace sonoskin
