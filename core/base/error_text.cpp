#include "core/base/error_text.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <new>

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
  if (dynamic_cast<const Error*>(&error)) return error.what();
  if (dynamic_cast<const std::bad_alloc*>(&error))
    return "There is not enough memory; close other programs, or take a smaller volume or a lower "
           "mesh.resolution.";
  return fmt::format("Something failed that should not ({}); report it with what was done.", error.what());
}

std::string systemCause(int number) { return fmt::format("{}; {}", std::strerror(number), helpFor(number)); }

}  // namespace sonoskin
