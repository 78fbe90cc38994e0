#include "app/batch/waiting_picture.h"

#include <chrono>
#include <utility>

#include "core/base/error.h"

namespace sonoskin {

void WaitingPicture::Turn::makeCurrent() {
  if (!context_) context_ = given_.get_future().get();
  if (!context_) throw Cancelled();
  context_->makeCurrent();
}

void WaitingPicture::Turn::release() {
  if (context_) std::exchange(context_, nullptr)->release();
}

WaitingPicture::WaitingPicture(Make make) {
  sink_.report = [this](double fraction) { fraction_ = fraction; };
  picture_ = std::async(std::launch::async, [this, make = std::move(make)] {
    // The context must not stay with a thread that ends, whatever happens.
    struct Release {
      Turn& turn;
      ~Release() { turn.release(); }
    } release{turn_};
    return make(turn_, Progress(sink_));
  });
}

WaitingPicture::~WaitingPicture() {
  if (!picture_.valid()) return;
  sink_.cancel = true;
  if (!handed_) turn_.refuse();
  picture_.wait();
}

Image WaitingPicture::take(gl::Context& context, const Progress& progress) {
  constexpr auto kLook = std::chrono::milliseconds(20);
  context.release();
  handed_ = true;
  turn_.give(context);
  while (picture_.wait_for(kLook) != std::future_status::ready) progress.update(fraction_);
  return picture_.get();
}

}  // namespace sonoskin
