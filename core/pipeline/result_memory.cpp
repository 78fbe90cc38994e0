#include "core/pipeline/result_memory.h"

#include <algorithm>
#include <utility>

namespace sonoskin {

void ResultMemory::beginRun(bool askedFor) {
  ++run_;
  askedFor_ = askedFor;
}

const std::any* ResultMemory::findAny(const Key& key) {
  const auto it = std::ranges::find(entries_, key, &Entry::key);
  if (it == entries_.end()) return nullptr;
  it->run = run_;
  it->askedFor |= askedFor_;
  std::rotate(it, it + 1, entries_.end());
  return &entries_.back().value;
}

void ResultMemory::add(const Key& key, std::any value, std::size_t bytes) {
  entries_.push_back({key, std::move(value), bytes, run_, askedFor_});
  bytes_ += bytes;
  makeRoom();
}

void ResultMemory::makeRoom() {
  for (const bool askedFor : {false, true})
    for (auto it = entries_.begin(); it != entries_.end() && bytes_ > budget_;) {
      const bool goes = it->run != run_ && it->askedFor == askedFor;
      if (goes) bytes_ -= it->bytes;
      it = goes ? entries_.erase(it) : it + 1;
    }
}

void ResultMemory::forget() {
  entries_.clear();
  bytes_ = 0;
}

}  // namespace sonoskin
