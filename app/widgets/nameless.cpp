#include "app/widgets/nameless.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include "core/io/file_formats.h"

namespace sonoskin::ui {
namespace {

constexpr std::string_view kBlank = "[file]", kAround = ".,;:!?()'\"";

void replaceAll(std::string& text, const std::string& what) {
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + kBlank.size()))
    text.replace(at, what.size(), kBlank);
}

bool hasEnding(std::string_view word) {
  std::string lower(word);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const FileKind kind : {FileKind::readVolume, FileKind::writtenVolume, FileKind::readMesh,
                              FileKind::writtenMesh, FileKind::picture, FileKind::recipe})
    for (const std::string& ending : extensionsOf(kind))
      if (lower.size() > ending.size() && lower.ends_with(ending)) return true;
  return false;
}

// What a word is without the marks around it.
std::string_view bare(std::string_view word) {
  while (!word.empty() && kAround.find(word.front()) != kAround.npos) word.remove_prefix(1);
  while (!word.empty() && kAround.find(word.back()) != kAround.npos) word.remove_suffix(1);
  return word;
}

bool isName(std::string_view word) { return word.find('/') != word.npos || hasEnding(word); }

}  // namespace

std::string withoutNames(std::string sentence, std::span<const std::filesystem::path> files) {
  std::vector<std::string> names;
  for (const std::filesystem::path& file : files)
    for (const std::string& name :
         {file.string(), file.parent_path().string(), file.filename().string(), file.stem().string()})
      if (name.size() > 2) names.push_back(name);
  std::ranges::sort(names, std::ranges::greater(), &std::string::size);
  for (const std::string& name : names) replaceAll(sentence, name);
  std::string out;
  for (std::size_t at = 0; at < sentence.size();) {
    const std::size_t end = std::min(sentence.find(' ', at), sentence.size());
    const std::string_view word = std::string_view(sentence).substr(at, end - at), name = bare(word);
    if (isName(name)) {
      out.append(word.begin(), name.begin());
      out += kBlank;
      out.append(name.end(), word.end());
    } else {
      out += word;
    }
    if (end < sentence.size()) out += ' ';
    at = end + 1;
  }
  return out;
}

}  // namespace sonoskin::ui
