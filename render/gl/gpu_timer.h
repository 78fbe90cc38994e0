#pragma once

#include "render/gl/object.h"

namespace sonoskin::gl {

// GpuTimer: how long the GPU works on what is drawn between begin() and end(). Not to be nested.
class GpuTimer {
 public:
  GpuTimer();

  void begin();
  void end();
  // seconds: of the last measured piece; waits for it. 0 before the first.
  double seconds() const;

 private:
  struct Traits {
    static void destroy(unsigned name);
  };
  Object<Traits> begin_,
      end_;  // timestamps: software rasterisers get elapsed-time queries without draws wrong
  bool measured_ = false;
};

}  // namespace sonoskin::gl
