#include "core/base/error_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <new>
#include <string_view>

#include "core/base/error.h"

namespace sonoskin {
namespace {

const char* helpFor(int number) {
  switch (number) {
    case ENOSPC:
    case EDQUOT:
      return "make room or choose another place";
    case EFBIG:
      return "raise the limit of file sizes or choose another place";
    case EACCES:
    case EPERM:
      return "check the permissions or choose another place";
    case EMFILE:
    case ENFILE:
    case ENOMEM:
      return "close other programs";
    default:
      return "choose another place";
  }
}

}  // namespace

std::string errorText(const std::exception& error) {
  if (dynamic_cast<const Error*>(&error)) return asSentence(error.what());
  if (dynamic_cast<const std::bad_alloc*>(&error))
    return "There is not enough memory; close other programs, or take a smaller volume or a lower "
           "mesh.resolution.";
  return fmt::format("Something failed that should not ({}); report it with what was done.", error.what());
}

std::string asSentence(std::string text) {
  // A file may be called by any other word.
  static constexpr std::array<std::string_view, 20> kBeginnings{
      "a",       "across", "edges", "an",   "every", "for",   "is",   "it",   "no",    "not",
      "nothing", "of",     "one",   "only", "the",   "there", "this", "what", "where", "which"};
  const std::size_t end = text.find(' ');
  if (end != std::string::npos && std::ranges::count(kBeginnings, std::string_view(text).substr(0, end)) > 0)
    text[0] = char(text[0] - 'a' + 'A');
  if (!text.empty() && std::string_view(".?!").find(text.back()) == std::string_view::npos) text += '.';
  return text;
}

std::string systemCause(int number) { return fmt::format("{}; {}", std::strerror(number), helpFor(number)); }

}  // namespace sonoskin
