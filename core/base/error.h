#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace sonoskin {

// Error: what a person can mend. The text is one sentence for that person: what, where, what to do.
class Error : public std::runtime_error {
 public:
  enum class Kind {
    input,  // the file or the data (exit status 3)
    usage,  // the command line or a parameter (exit status 2)
    system  // disk, display, driver (exit status 1)
  };
  explicit Error(const std::string& sentence, Kind kind = Kind::input)
      : std::runtime_error(sentence), kind_(kind) {}
  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

// Cancelled: the person asked to stop. Not an error, so it does not derive from one.
struct Cancelled {};

// require: throws Error with the formatted sentence unless `condition` holds. For public entries.
template <class... Args>
void require(bool condition, fmt::format_string<Args...> sentence, Args&&... args) {
  if (!condition) throw Error(fmt::format(sentence, std::forward<Args>(args)...));
}

}  // namespace sonoskin
