#include "render/gl/program.h"

#include <glad/gl.h>

#include <chrono>
#include <cstdio>

#include "core/base/error.h"
#include "render/gl/shader_source.h"

namespace sonoskin::gl {
namespace {

struct ShaderTraits {
  static void destroy(unsigned name) { glDeleteShader(name); }
};
using Shader = Object<ShaderTraits>;

GLenum stageOf(const std::string& file) {
  return file.ends_with(".vert") ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER;
}

Shader compile(const std::string& file, const ShaderSource& source) {
  Shader shader(glCreateShader(stageOf(file)));
  const char* text = source.text.c_str();
  glShaderSource(shader.name(), 1, &text, nullptr);
  glCompileShader(shader.name());
  GLint done = 0, length = 0;
  glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &done);
  if (done) return shader;
  glGetShaderiv(shader.name(), GL_INFO_LOG_LENGTH, &length);
  std::string log(std::size_t(length), '\0');
  glGetShaderInfoLog(shader.name(), length, nullptr, log.data());
  throw Error(fmt::format("the shader {} does not compile: {}", file, mapLog(log.c_str(), source)),
              Error::Kind::system);
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Program::Program(std::vector<std::string> files, std::vector<std::string> defines)
    : files_(std::move(files)), defines_(std::move(defines)) {
  build();
}

void Program::build() {
  std::vector<Shader> shaders;
  sources_.clear();
  for (const auto& file : files_) {
    const auto source = expandShader(file, defines_, readShader);
    sources_.insert(sources_.end(), source.files.begin(), source.files.end());
    stamp_ = shaderStamp(sources_);
    shaders.push_back(compile(file, source));
  }
  Object<Traits> program(glCreateProgram());
  for (const auto& shader : shaders) glAttachShader(program.name(), shader.name());
  glLinkProgram(program.name());
  GLint done = 0;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &done);
  if (!done) {
    std::string log(4096, '\0');
    glGetProgramInfoLog(program.name(), GLsizei(log.size()), nullptr, log.data());
    throw Error(fmt::format("the shaders {} do not fit together: {}", fmt::join(files_, ", "), log.c_str()),
                Error::Kind::system);
  }
  object_ = std::move(program);
  locations_.clear();
}

void Program::reloadIfChanged() {
  const double time = now();
  if (time - lastLook_ < 0.5) return;
  lastLook_ = time;
  const long long stamp = shaderStamp(sources_);
  if (stamp == stamp_) return;
  stamp_ = stamp;
  const auto before = sources_;
  try {
    build();
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    sources_ = before;
  }
}

void Program::use() {
  if (!embeddedShaders().size()) reloadIfChanged();
  glUseProgram(name());
}

int Program::location(const char* uniform) {
  const auto found = locations_.find(std::string_view(uniform));
  if (found != locations_.end()) return found->second;
  return locations_[uniform] = glGetUniformLocation(name(), uniform);
}

void Program::set(const char* u, int v) { glProgramUniform1i(name(), location(u), v); }
void Program::set(const char* u, float v) { glProgramUniform1f(name(), location(u), v); }
void Program::set(const char* u, const glm::vec2& v) { glProgramUniform2fv(name(), location(u), 1, &v[0]); }
void Program::set(const char* u, const glm::vec3& v) { glProgramUniform3fv(name(), location(u), 1, &v[0]); }
void Program::set(const char* u, const glm::vec4& v) { glProgramUniform4fv(name(), location(u), 1, &v[0]); }
void Program::set(const char* u, const glm::ivec2& v) { glProgramUniform2iv(name(), location(u), 1, &v[0]); }
void Program::set(const char* u, const glm::ivec3& v) { glProgramUniform3iv(name(), location(u), 1, &v[0]); }
void Program::set(const char* u, const glm::mat3& v) {
  glProgramUniformMatrix3fv(name(), location(u), 1, GL_FALSE, &v[0][0]);
}
void Program::set(const char* u, const glm::mat4& v) {
  glProgramUniformMatrix4fv(name(), location(u), 1, GL_FALSE, &v[0][0]);
}
void Program::set(const char* u, std::span<const float> v) {
  glProgramUniform1fv(name(), location(u), GLsizei(v.size()), v.data());
}

// One that is in use would stay half alive: whoever puts back what was in use before (as Dear ImGui does) fails.
void Program::Traits::destroy(unsigned name) {
  GLint used = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &used);
  if (unsigned(used) == name) glUseProgram(0);
  glDeleteProgram(name);
}

void drawFullScreen(DepthWrite depth) {
  // Core profile demands a vertex array even where the vertex shader reads nothing from it.
  unsigned vertexArray = 0;
  glCreateVertexArrays(1, &vertexArray);
  glBindVertexArray(vertexArray);
  if (depth == DepthWrite::on) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
  } else {
    glDisable(GL_DEPTH_TEST);
  }
  glDisable(GL_CULL_FACE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDeleteVertexArrays(1, &vertexArray);
}

}  // namespace sonoskin::gl
