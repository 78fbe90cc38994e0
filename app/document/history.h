#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace sonoskin {

// History: a value and its earlier and later versions, for undo and redo.
template <class T>
class History {
 public:
  explicit History(T first) : versions_{std::move(first)} {}

  const T& current() const { return versions_[position_]; }
  // The versions from the oldest that is kept, and which of them is the current one.
  std::size_t size() const { return versions_.size(); }
  std::size_t position() const { return position_; }
  const T& at(std::size_t n) const { return versions_[n]; }
  bool canUndo() const { return position_ > 0; }
  bool canRedo() const { return position_ + 1 < versions_.size(); }

  // push: a new version after the current one; what was undone is forgotten, and the oldest beyond kMost.
  void push(T value) {
    versions_.resize(position_ + 1, value);
    versions_.push_back(std::move(value));
    if (versions_.size() > kMost) versions_.erase(versions_.begin());
    position_ = versions_.size() - 1;
  }
  // changeAll: what is true of all versions.
  template <class F>
  void changeAll(F&& change) {
    for (T& version : versions_) change(version);
  }
  // undo, redo: one step, where there is one.
  void undo() {
    if (canUndo()) --position_;
  }
  void redo() {
    if (canRedo()) ++position_;
  }

  // goTo: any of the versions; the last one where there are not so many.
  void goTo(std::size_t n) { position_ = n < versions_.size() ? n : versions_.size() - 1; }

 private:
  static constexpr std::size_t kMost = 500;
  std::vector<T> versions_;
  std::size_t position_ = 0;
};

}  // namespace sonoskin
