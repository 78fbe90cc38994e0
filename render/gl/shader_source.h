#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sonoskin::gl {

// ShaderSource: GLSL that is ready to compile, and where its lines came from.
//   files   by the source number that #line directives in the text give to the compiler
struct ShaderSource {
  std::string text;
  std::vector<std::string> files;
};

using ReadShader = std::function<std::optional<std::string>(const std::string& name)>;

// expandShader: the text of shader `name` with every #include "file" replaced by that file (once: later
// includes of the same file are empty), a #version line, and a #define line for each of `defines` ("SKIN",
// "STEPS 64").
//   read     gives a file's text by its name below shaders/; a pure function of it all
//   errors   Error (system): a file is missing; the sentence names the file and line that asked for it
ShaderSource expandShader(const std::string& name, std::span<const std::string> defines,
                          const ReadShader& read);

// mapLog: a compiler's log with the source numbers of its messages ("2:14(3): error ...", "2(14) : error
// ...") replaced by "file:line".
std::string mapLog(const std::string& log, const ShaderSource& source);

// readShader: a shader file's text: embedded in the program, or from the source tree where it is built so.
std::optional<std::string> readShader(const std::string& name);

// shaderStamp: changes when one of the files changes on disk; always 0 when shaders are embedded.
long long shaderStamp(std::span<const std::string> files);

// EmbeddedShader: a file below shaders/ that was put into the program when it was built.
struct EmbeddedShader {
  std::string_view name, text;
};
std::span<const EmbeddedShader> embeddedShaders();  // empty where shaders are read from the source tree

}  // namespace sonoskin::gl
