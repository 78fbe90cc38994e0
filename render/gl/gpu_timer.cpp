#include "render/gl/gpu_timer.h"

#include <glad/gl.h>

namespace sonoskin::gl {

GpuTimer::GpuTimer() {
  unsigned name = 0;
  glCreateQueries(GL_TIME_ELAPSED, 1, &name);
  query_ = Object<Traits>(name);
}

void GpuTimer::begin() { glBeginQuery(GL_TIME_ELAPSED, query_.name()); }

void GpuTimer::end() {
  glEndQuery(GL_TIME_ELAPSED);
  measured_ = true;
}

double GpuTimer::seconds() const {
  GLuint64 nanoseconds = 0;
  if (measured_) glGetQueryObjectui64v(query_.name(), GL_QUERY_RESULT, &nanoseconds);
  return double(nanoseconds) * 1e-9;
}

void GpuTimer::Traits::destroy(unsigned name) { glDeleteQueries(1, &name); }

}  // namespace sonoskin::gl
