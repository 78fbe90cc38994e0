#pragma once

#include <algorithm>
#include <deque>
#include <memory>

#include "core/base/hash.h"

namespace sonoskin {

// Stage: remembers the last few results of one step by the key of everything they depend on. A result that is
// asked for again costs nothing; a computation that throws leaves the memory as it was.
template <class T>
class Stage {
 public:
  explicit Stage(std::size_t capacity) : capacity_(capacity) {}

  // find: the remembered result, or empty.
  std::shared_ptr<const T> find(const Key& key) {
    const auto it =
        std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.key == key; });
    if (it == entries_.end()) return nullptr;
    std::rotate(entries_.begin(), it, it + 1);  // most recently used first
    return entries_.front().value;
  }

  std::shared_ptr<const T> remember(const Key& key, T value) {
    return remember(key, std::make_shared<const T>(std::move(value)));
  }
  std::shared_ptr<const T> remember(const Key& key, std::shared_ptr<const T> value) {
    entries_.push_front({key, std::move(value)});
    if (entries_.size() > capacity_) entries_.pop_back();
    return entries_.front().value;
  }

 private:
  struct Entry {
    Key key;
    std::shared_ptr<const T> value;
  };
  std::size_t capacity_;
  std::deque<Entry> entries_;
};

}  // namespace sonoskin
