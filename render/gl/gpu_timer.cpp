#include "render/gl/gpu_timer.h"

#include <glad/gl.h>

namespace sonoskin::gl {

GpuTimer::GpuTimer() {
  unsigned names[2] = {};
  glCreateQueries(GL_TIMESTAMP, 2, names);
  begin_ = Object<Traits>(names[0]);
  end_ = Object<Traits>(names[1]);
}

void GpuTimer::begin() { glQueryCounter(begin_.name(), GL_TIMESTAMP); }

void GpuTimer::end() {
  glQueryCounter(end_.name(), GL_TIMESTAMP);
  measured_ = true;
}

double GpuTimer::seconds() const {
  if (!measured_) return 0;
  GLuint64 from = 0, to = 0;  // nanoseconds
  glGetQueryObjectui64v(begin_.name(), GL_QUERY_RESULT, &from);
  glGetQueryObjectui64v(end_.name(), GL_QUERY_RESULT, &to);
  return to > from ? double(to - from) * 1e-9 : 0;
}

void GpuTimer::Traits::destroy(unsigned name) { glDeleteQueries(1, &name); }

}  // namespace sonoskin::gl
