#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace sonoskin {

// LargeArrayAllocator: memory for volumes. The system hands out memory in pages when they are first written, and with
// pages of 4 KB that costs more than most of what we do to a volume: so large blocks ask for pages of 2 MB. New
// elements are not set to zero unless a value is given: whoever fills a volume does so on all threads.
template <class T>
struct LargeArrayAllocator {
  using value_type = T;

  LargeArrayAllocator() = default;
  template <class U>
  LargeArrayAllocator(const LargeArrayAllocator<U>&) {}

  T* allocate(std::size_t count) {
    constexpr std::size_t kPage = std::size_t(2) << 20;
    if (count > (std::size_t(-1) - kPage) / sizeof(T)) throw std::bad_array_new_length();
    const std::size_t bytes = count * sizeof(T);
    const bool large = bytes >= 2 * kPage;
    const std::size_t alignment = large ? kPage : 64;
    const std::size_t rounded = (bytes + alignment - 1) / alignment * alignment;
    void* memory = std::aligned_alloc(alignment, rounded);
    if (!memory) throw std::bad_alloc();
#if defined(MADV_HUGEPAGE)
    if (large) madvise(memory, rounded, MADV_HUGEPAGE);  // a wish: without it everything works, slower
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  template <class U>
  void construct(U* place) {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }
  bool operator==(const LargeArrayAllocator&) const { return true; }
};

// LargeArray: a std::vector for millions of numbers. LargeArray<float>(n) and resize(n) leave new numbers
// unset; LargeArray<float>(n, 0.0f) sets them.
template <class T>
using LargeArray = std::vector<T, LargeArrayAllocator<T>>;

}  // namespace sonoskin
