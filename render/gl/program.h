#pragma once

#include <glm/glm.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "render/gl/object.h"

namespace sonoskin::gl {

// Program: shaders, linked. The stage of a file is its suffix: .vert, .frag.
class Program {
 public:
  // Program: compiles the files below shaders/, each with the same defines.
  //   errors  Error (system): a shader does not compile; the sentence holds the compiler's log with file:line
  Program(std::vector<std::string> files, std::vector<std::string> defines = {});

  // use: draws of this thread run it. Where shaders are read from the source tree, a changed one is compiled
  // first (looked at twice a second); one that fails is reported on standard error and the old program stays.
  void use();

  // set: gives a uniform its value; one that the compiler dropped is passed over.
  void set(const char* uniform, int value);
  void set(const char* uniform, float value);
  void set(const char* uniform, const glm::vec2& value);
  void set(const char* uniform, const glm::vec3& value);
  void set(const char* uniform, const glm::vec4& value);
  void set(const char* uniform, const glm::ivec2& value);
  void set(const char* uniform, const glm::ivec3& value);
  void set(const char* uniform, const glm::mat3& value);
  void set(const char* uniform, const glm::mat4& value);
  void set(const char* array, std::span<const float> values);

  unsigned name() const { return object_.name(); }

 private:
  struct Traits {
    static void destroy(unsigned name);
  };
  void build();
  void reloadIfChanged();
  int location(const char* uniform);

  std::vector<std::string> files_, defines_;
  std::vector<std::string> sources_;  // all files, included ones too
  long long stamp_ = 0;
  double lastLook_ = 0;  // seconds
  std::map<std::string, int, std::less<>> locations_;
  Object<Traits> object_;
};

enum class DepthWrite { off, on };

// drawFullScreen: one triangle over the whole target, for programs with common/fullscreen.vert.
//   depth  on: the fragment shader's depth is stored, whatever was there
void drawFullScreen(DepthWrite depth = DepthWrite::off);

}  // namespace sonoskin::gl
