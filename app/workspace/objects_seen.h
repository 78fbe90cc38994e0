#pragma once

#include <array>
#include <cstddef>
#include <memory>

namespace sonoskin {

// ObjectsSeen: which objects a picture was drawn from, or a state was set for. An address may come back when its object is
// gone; the owner that a weak pointer holds on to does not, and no memory but that is kept.
template <std::size_t N>
class ObjectsSeen {
 public:
  using Objects = std::array<std::shared_ptr<const void>, N>;

  // see: notes the objects; whether any is another than the last time. At first there are none.
  bool see(const Objects& objects) {
    bool others = false;
    for (std::size_t i = 0; i < N; ++i) {
      others = others || objects[i].owner_before(seen_[i]) || seen_[i].owner_before(objects[i]);
      seen_[i] = objects[i];
    }
    return others;
  }

 private:
  std::array<std::weak_ptr<const void>, N> seen_;
};

}  // namespace sonoskin
