#include "render/gl/shader_source.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "core/base/error.h"

namespace sonoskin::gl {
namespace {

// The file that a line of the form  #include "file"  names.
std::optional<std::string> includedFile(const std::string& line) {
  static const std::regex pattern(R"re(^\s*#\s*include\s*"([^"]+)"\s*$)re");
  std::smatch match;
  if (!std::regex_match(line, match, pattern)) return std::nullopt;
  return match[1].str();
}

class Expander {
 public:
  explicit Expander(const ReadShader& read) : read_(read) {}

  void addFile(const std::string& name, const std::string& askedBy) {
    auto& files = source_.files;
    if (std::find(files.begin(), files.end(), name) != files.end()) return;
    const auto text = read_(name);
    if (!text)
      throw Error(
          fmt::format("the shader {} is missing{}", name, askedBy.empty() ? "" : ", asked for in " + askedBy),
          Error::Kind::system);
    const std::size_t number = files.size();
    files.push_back(name);
    addLine(fmt::format("#line 1 {}", number));
    std::istringstream lines(*text);
    std::string line;
    for (int i = 1; std::getline(lines, line); ++i) {
      const auto include = includedFile(line);
      if (!include) {
        addLine(line);
        continue;
      }
      addFile(*include, fmt::format("{}:{}", name, i));
      addLine(fmt::format("#line {} {}", i + 1, number));
    }
  }
  void addLine(const std::string& line) { source_.text += line + '\n'; }
  ShaderSource take() { return std::move(source_); }

 private:
  const ReadShader& read_;
  ShaderSource source_;
};

}  // namespace

ShaderSource expandShader(const std::string& name, std::span<const std::string> defines,
                          const ReadShader& read) {
  Expander expander(read);
  expander.addLine("#version 450 core");
  for (const auto& define : defines) expander.addLine("#define " + define);
  expander.addFile(name, "");
  return expander.take();
}

std::string mapLog(const std::string& log, const ShaderSource& source) {
  // Mesa writes source:line(column), NVIDIA source(line), AMD and Intel source:line.
  static const std::regex pattern(R"re(^(\w+: )?(\d+)[:(](\d+)\)?(\(\d+\))?)re");
  std::istringstream lines(log);
  std::string line, mapped;
  while (std::getline(lines, line)) {
    std::smatch match;
    if (std::regex_search(line, match, pattern)) {
      const std::size_t number = std::stoul(match[2]);
      if (number < source.files.size())
        line = match[1].str() + source.files[number] + ":" + match[3].str() + match.suffix().str();
    }
    mapped += line + '\n';
  }
  return mapped;
}

#ifdef SONOSKIN_SHADER_FOLDER

std::span<const EmbeddedShader> embeddedShaders() { return {}; }

std::optional<std::string> readShader(const std::string& name) {
  std::ifstream file(std::filesystem::path(SONOSKIN_SHADER_FOLDER) / name);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

long long shaderStamp(std::span<const std::string> files) {
  long long stamp = 0;
  for (const auto& name : files) {
    std::error_code gone;  // an editor may be about to replace the file: look again next time
    const auto time =
        std::filesystem::last_write_time(std::filesystem::path(SONOSKIN_SHADER_FOLDER) / name, gone);
    if (!gone) stamp = std::max(stamp, static_cast<long long>(time.time_since_epoch().count()));
  }
  return stamp;
}

#else

std::optional<std::string> readShader(const std::string& name) {
  for (const auto& shader : embeddedShaders())
    if (shader.name == name) return std::string(shader.text);
  return std::nullopt;
}

long long shaderStamp(std::span<const std::string>) { return 0; }

#endif

}  // namespace sonoskin::gl
