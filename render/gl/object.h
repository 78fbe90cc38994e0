#pragma once

#include <utility>

namespace sonoskin::gl {

// Object: owns one OpenGL name; move-only, may be empty (0). The only place where names are deleted.
// Traits::destroy(name) needs the context current in which the name was made.
template <class Traits>
class Object {
 public:
  Object() = default;
  explicit Object(unsigned name) : name_(name) {}
  Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0u)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;
  ~Object() {
    if (name_) Traits::destroy(name_);
  }

  unsigned name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  unsigned name_ = 0;
};

}  // namespace sonoskin::gl
