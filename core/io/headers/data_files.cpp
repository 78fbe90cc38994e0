#include "core/io/headers/data_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

#include "core/base/error.h"
#include "core/io/file_bytes.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostFiles = 65535;

// A conversion such as %d, %3d or %03d; printf() itself would obey whatever a stranger has written.
struct Conversion {
  std::size_t begin = 0, end = 0;
  std::size_t width = 0;
  bool zeros = false;
};

std::optional<Conversion> conversionIn(std::string_view name) {
  Conversion found;
  found.begin = name.find('%');
  if (found.begin == std::string_view::npos) return {};
  std::size_t at = found.begin + 1;
  if (at < name.size() && name[at] == '0') found.zeros = true, ++at;
  if (at < name.size() && name[at] >= '1' && name[at] <= '9') found.width = std::size_t(name[at++] - '0');
  if (at >= name.size() || (name[at] != 'd' && name[at] != 'i' && name[at] != 'u')) return {};
  found.end = at + 1;
  if (name.find('%', found.end) != std::string_view::npos) return {};
  return found;
}

}  // namespace

std::uintmax_t dataFileSize(const fs::path& file, const fs::path& header) {
  if (file == header) return fileSize(header);
  std::error_code code;
  require(fs::is_regular_file(file, code),
          "{} names a data file that is not beside it; put both into one folder, or correct the header.",
          header.string());
  require(::access(file.c_str(), R_OK) == 0,
          "{} names a data file that may not be read; check its permissions.", header.string());
  const std::uintmax_t size = fs::file_size(file, code);
  require(!code && size > 0, "{} names a data file that is empty; get a fresh copy.", header.string());
  return size;
}

bool isFileList(std::string_view text) {
  const auto parts = words(text);
  return !parts.empty() && parts[0] == "LIST";
}

std::vector<std::string> listedFiles(HeaderLines& lines, const fs::path& header) {
  std::vector<std::string> files;
  while (const auto line = lines.next()) {
    if (trimmed(*line).empty()) continue;
    require(files.size() < kMostFiles, "{} names more than {} data files; save it as one file.",
            header.string(), kMostFiles);
    files.emplace_back(trimmed(*line));
  }
  return files;
}

bool isPattern(std::string_view text) {
  const auto parts = words(text);
  return parts.size() >= 3 && parts[0].find('%') != std::string_view::npos &&
         parseNumber<long>(parts[1]).has_value() && parseNumber<long>(parts[2]).has_value();
}

FilePattern patternOf(std::string_view text, const fs::path& header) {
  const auto parts = words(text);
  FilePattern pattern;
  const auto number = [&](std::size_t n) {
    return n < parts.size() ? parseNumber<long>(parts[n]) : std::optional<long>(1);
  };
  const auto first = number(1), last = number(2), step = number(3);
  require(parts.size() >= 3 && conversionIn(parts[0]) && first && last && step && *step != 0 &&
              std::abs(*first) <= 1'000'000'000 && std::abs(*last) <= 1'000'000'000 &&
              std::abs(*step) <= 1'000'000'000 && (*last - *first) / *step >= 0,
          "{} names its data files by a pattern that is not known here; list them one by one.",
          header.string());
  require(std::size_t((*last - *first) / *step) < kMostFiles,
          "{} names more than {} data files; save it as one file.", header.string(), kMostFiles);
  return {std::string(parts[0]), *first, *last, *step};
}

std::vector<std::string> namesOf(const FilePattern& pattern) {
  const auto conversion = conversionIn(pattern.name);
  std::vector<std::string> names;
  const long count = (pattern.last - pattern.first) / pattern.step + 1;
  for (long n = 0; conversion && n < count; ++n) {
    const long number = pattern.first + n * pattern.step;
    const std::string digits = conversion->zeros ? fmt::format("{:0{}}", number, conversion->width)
                                                 : fmt::format("{:{}}", number, conversion->width);
    names.push_back(pattern.name.substr(0, conversion->begin) + digits +
                    pattern.name.substr(conversion->end));
  }
  return names;
}

}  // namespace sonoskin
