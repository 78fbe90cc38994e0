#pragma once

#include <stdexcept>
#include <thread>

#include "app/document/session.h"
#include "core/base/timer.h"

namespace sonoskin::test {

inline Parameters tinyPhantom() {
  Parameters parameters;
  parameters.phantom.dims = {78, 43, 31};
  return parameters;
}
// tinySurface: the same with a mesh that takes no time.
inline Parameters tinySurface() {
  Parameters parameters = tinyPhantom();
  parameters.mesh.resolution = 60;
  parameters.surface.minClusterArea = 20;
  return parameters;
}

// wait: polls until the session rests; false after a minute.
inline bool wait(Session& session) {
  const Timer timer;
  do {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    session.poll();
    if (timer.seconds() > 60) return false;
  } while (session.activity().busy);
  session.poll();
  return true;
}

// OpenSession: a session that has the phantom open, and rests.
struct OpenSession : Session {
  explicit OpenSession(const Parameters& parameters = tinyPhantom()) : Session(parameters) {
    openPhantom();
    if (!wait(*this)) throw std::runtime_error("The phantom was not opened within a minute");
  }
};

// The middle of the points, and a ball around it.
inline Brush ballOnTheSurface(const Session& session) {
  const auto& positions = session.results().points->positions;
  const glm::dvec3 at(positions[positions.size() / 2]);
  return {at, at, 12, true};
}

}  // namespace sonoskin::test
