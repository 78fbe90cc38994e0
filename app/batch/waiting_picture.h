#pragma once

#include <atomic>
#include <functional>
#include <future>

#include "core/base/progress.h"
#include "core/io/image.h"
#include "render/gl/context.h"

namespace sonoskin {

// WaitingPicture: a picture that is prepared on a thread of its own while this one does something else, and drawn there once
// that thread is handed the OpenGL context, which only one can have.
class WaitingPicture {
 public:
  // make  prepares what needs no OpenGL, then calls makeCurrent() of the context it is given, which waits for its turn, and
  //       draws; all of its OpenGL objects are gone when it returns
  using Make = std::function<Image(gl::Context& context, const Progress& progress)>;
  explicit WaitingPicture(Make make);
  ~WaitingPicture();  // of a picture that was not taken, ends the work at its next look
  WaitingPicture(const WaitingPicture&) = delete;
  WaitingPicture& operator=(const WaitingPicture&) = delete;

  // take: hands over the context, which is current on no thread afterwards, and waits for the picture; once.
  //   errors  those of `make`; Cancelled
  Image take(gl::Context& context, const Progress& progress);

 private:
  // Turn: stands for the context until it is handed over.
  class Turn final : public gl::Context {
   public:
    void give(gl::Context& context) { given_.set_value(&context); }
    void refuse() { given_.set_value(nullptr); }
    void makeCurrent() override;
    void release() override;

   private:
    std::promise<gl::Context*> given_;
    gl::Context* context_ = nullptr;
  };

  std::atomic<double> fraction_{0};
  ProgressSink sink_;
  Turn turn_;
  bool handed_ = false;
  std::future<Image> picture_;
};

}  // namespace sonoskin
