#pragma once

#include <any>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/hash.h"

namespace sonoskin {

// ResultMemory: remembers results of all stages by the key of everything that they depend on, within one budget in bytes.
// Where it is full the results go that were not used for longest: first those that only answered a slider, then those that
// a person asked for, and never one that the present run has used. A budget that is smaller than a run needs holds that run.
//   threads  one at a time
class ResultMemory {
 public:
  explicit ResultMemory(std::size_t budget) : budget_(budget) {}

  // beginRun: what is found or remembered from now on is in use until the next run begins.
  //   askedFor  a person waits for its results; else they answer a slider
  void beginRun(bool askedFor);

  // find: the remembered result, or empty.
  template <class T>
  std::shared_ptr<const T> find(const Key& key) {
    const std::any* value = findAny(key);
    const auto* result = std::any_cast<std::shared_ptr<const T>>(value);
    return result ? *result : nullptr;
  }
  // remember: a result whose key is not known yet.
  //   bytes  what it takes
  template <class T>
  void remember(const Key& key, std::shared_ptr<const T> value, std::size_t bytes) {
    add(key, std::move(value), bytes);
  }
  // forget: all of them.
  void forget();

 private:
  struct Entry {
    Key key;
    std::any value;  // std::shared_ptr<const T>
    std::size_t bytes = 0;
    std::uint64_t run = 0;  // the last that used it
    bool askedFor = false;  // by any run
  };
  const std::any* findAny(const Key& key);
  void add(const Key& key, std::any value, std::size_t bytes);
  void makeRoom();

  std::vector<Entry> entries_;  // the last used at the end
  std::size_t budget_, bytes_ = 0;
  std::uint64_t run_ = 0;
  bool askedFor_ = false;
};

}  // namespace sonoskin
