#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "core/mesh/mesh.h"
#include "render/gl/context.h"

namespace sonoskin {

// GlTest: a test with an EGL context; it fails on any OpenGL error that the test causes.
class GlTest : public testing::Test {
 protected:
  void SetUp() override { errorsBefore_ = gl::glErrorCount(); }
  void TearDown() override { EXPECT_EQ(gl::glErrorCount(), errorsBefore_) << gl::lastGlError(); }
  gl::Context& context() { return *context_; }

 private:
  std::unique_ptr<gl::Context> context_ = gl::makeOffscreenContext(gl::Backend::egl);
  int errorsBefore_ = 0;
};

// sphereMesh: a sphere of latitude rings with exact normals.
inline Mesh sphereMesh(const glm::vec3& centre, float radius, int rings = 64) {
  Mesh mesh;
  const int columns = 2 * rings;
  for (int r = 0; r <= rings; ++r)
    for (int c = 0; c <= columns; ++c) {
      const float theta = 3.14159265f * float(r) / float(rings), phi = 6.2831853f * float(c) / float(columns);
      const glm::vec3 n(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      mesh.positions.push_back(centre + radius * n);
      mesh.normals.push_back(n);
    }
  for (int r = 0; r < rings; ++r)
    for (int c = 0; c < columns; ++c) {
      const auto a = std::uint32_t(r * (columns + 1) + c), b = a + std::uint32_t(columns) + 1;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  return mesh;
}

}  // namespace sonoskin
