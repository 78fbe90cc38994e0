#include <algorithm>
#include <cctype>

#include "app/texts/texts.h"
#include "app/widgets/file_dialog.h"
#include "core/base/error.h"

namespace sonoskin::ui {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

FilePurposeText purposeText(FilePurpose purpose) {
  switch (purpose) {
    case FilePurpose::open:
      return {"Open volume or session", "Open", false, FileKind::opened};
    case FilePurpose::findVolume:
      return {"Choose the session's volume", "Open", false, FileKind::readVolume};
    case FilePurpose::openSession:
      return {"Open session", "Open", false, FileKind::session};
    case FilePurpose::saveSession:
      return {"Save session", "Save", true, FileKind::session};
    case FilePurpose::openErased:
      return {"Open erased parts", "Open", false, FileKind::readVolume};
    case FilePurpose::saveErased:
      return {"Save erased parts", "Save", true, FileKind::writtenVolume};
    case FilePurpose::openRecipe:
      return {"Open recipe", "Open", false, FileKind::recipe};
    case FilePurpose::saveRecipe:
      return {"Save recipe", "Save", true, FileKind::recipe};
    case FilePurpose::saveMesh:
      return {"Save mesh", "Save", true, FileKind::writtenMesh};
    case FilePurpose::saveSequence:
      return {"Save a mesh of each time step", "Save", true, FileKind::writtenMesh};
    case FilePurpose::savePrint:
      return {"Save for printing", "Save", true, FileKind::printedMesh};
    case FilePurpose::saveScan:
      return {"Save scan for other programs", "Save", true, FileKind::writtenVolume};
    case FilePurpose::saveClassified:
      return {"Save classified volume", "Save", true, FileKind::writtenVolume};
    case FilePurpose::saveSkin:
      return {"Save surface with skin", "Save", true, FileKind::texturedMesh};
    case FilePurpose::saveLitSkin:
      return {"Save surface with skin and light", "Save", true, FileKind::texturedMesh};
    case FilePurpose::savePicture:
      return {"Save picture of the 3D view", "Save", true, FileKind::picture};
    case FilePurpose::saveMessages:
      return {"Save messages", "Save", true, FileKind::text};
    case FilePurpose::saveTurntable:
      return {"Save turntable of the 3D view", "Save", true, FileKind::picture};
    case FilePurpose::saveSheet:
      return {"Save contact sheet", "Save", true, FileKind::picture};
    case FilePurpose::savePoints:
      return {"Save points", "Save", true, FileKind::points};
    case FilePurpose::saveThinned:
      return {"Save thinned volume", "Save", true, FileKind::writtenVolume};
    case FilePurpose::saveReport:
      return {"Save report", "Save", true, FileKind::report};
  }
  return {};
}

std::vector<FileEntry> listFolder(const fs::path& folder, std::optional<FileKind> kind) {
  std::vector<FileEntry> entries;
  for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
    std::error_code error;
    const std::string name = file.path().filename().string();
    if (name.starts_with('.')) continue;
    if (file.is_directory(error)) {
      entries.push_back({name, true, 0});
    } else if (file.is_regular_file(error) && (!kind || formatNamed(*kind, name))) {
      const std::uintmax_t bytes = file.file_size(error);
      entries.push_back({name, false, error ? 0 : bytes});
    }
  }
  std::sort(entries.begin(), entries.end(), [](const FileEntry& a, const FileEntry& b) {
    return a.folder != b.folder ? a.folder : lower(a.name) < lower(b.name);
  });
  return entries;
}

void FileDialog::ask(FilePurpose wanted, const fs::path& start, const std::string& proposed) {
  purpose = wanted;
  opening = true;
  name = proposed;
  complaint.clear();
  replaceAsked = allFiles = false;
  std::error_code error;
  enter(fs::is_directory(start, error) ? start : fs::current_path(error));
}

void FileDialog::enter(const fs::path& wanted) {
  replaceAsked = false;
  complaint.clear();
  try {
    const fs::path full = fs::canonical(wanted);
    entries = listFolder(full, allFiles ? std::nullopt : std::optional(purposeText(*purpose).kind));
    folder = full;
  } catch (const fs::filesystem_error&) {
    complaint = trf("This folder cannot be read: {}", wanted.string());
  }
}

namespace {

std::string replacedText(const std::vector<fs::path>& files) {
  const std::string names = files.front().filename().string();
  if (files.size() == 1) return trf("{} is there already; press Replace to write over it.", names);
  const std::string others =
      files.size() == 2 ? files.back().filename().string() : trf("{} more files", files.size() - 1);
  return trf("{} and {} are there already; press Replace to write over them.", names, others);
}

// The name with the usual ending where it has none.
//   errors  Error: it has another one
fs::path withEnding(fs::path path, FileKind kind) {
  if (!path.has_extension()) path += extensionsOf(kind).front();
  requireFormat(kind, path);
  return path;
}

}  // namespace

std::optional<fs::path> accept(FileDialog& dialog) {
  const FilePurposeText text = purposeText(*dialog.purpose);
  const auto complain = [&](const std::string& sentence) {
    dialog.complaint = sentence;
    return std::nullopt;
  };
  std::error_code error;
  if (dialog.name.empty()) return complain(tr("Choose a file or type its name."));
  fs::path path = dialog.folder / dialog.name;  // a whole path stays what it is
  if (fs::is_directory(path, error)) {
    dialog.name.clear();
    dialog.enter(path);
    return {};
  }
  try {
    if (text.save) path = withEnding(path, text.kind);
  } catch (const Error& wrong) {
    return complain(trSentence(wrong.what()));
  }
  if (!text.save && !fs::exists(path, error))
    return complain(tr("There is no file of that name here; choose one of the list."));
  if (!text.save || dialog.replaceAsked) return path;
  if (const auto replaced = replacedFiles(*dialog.purpose, path); !replaced.empty()) {
    dialog.replaceAsked = true;
    return complain(replacedText(replaced));
  }
  return path;
}

}  // namespace sonoskin::ui
