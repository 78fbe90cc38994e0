#include <algorithm>
#include <cctype>

#include "app/widgets/file_dialog.h"

namespace sonoskin::ui {
namespace {

namespace fs = std::filesystem;

bool hasRecipe(FilePurpose purpose) {
  switch (purpose) {
    case FilePurpose::saveMesh:
    case FilePurpose::saveSequence:
    case FilePurpose::savePrint:
    case FilePurpose::saveSkin:
    case FilePurpose::saveLitSkin:
    case FilePurpose::savePicture:
    case FilePurpose::saveSheet:
    case FilePurpose::saveTurntable:
    case FilePurpose::saveReport:
      return true;
    default:
      return false;
  }
}

// Whether a name is that of a step of "face.ply": "face_0012.ply".
bool isStepOf(const fs::path& file, const fs::path& path) {
  const std::string name = file.stem().string(), stem = path.stem().string() + "_";
  return file.extension() == path.extension() && name.size() >= stem.size() + 4 && name.starts_with(stem) &&
         std::all_of(name.begin() + std::ptrdiff_t(stem.size()), name.end(),
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

std::vector<fs::path> stepsThere(const fs::path& path) {
  std::vector<fs::path> steps;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(path.parent_path(), error))
    if (isStepOf(entry.path(), path)) steps.push_back(entry.path());
  std::ranges::sort(steps);
  return steps;
}

}  // namespace

std::vector<fs::path> writtenFiles(FilePurpose purpose, const fs::path& path) {
  const auto beside = [&](const char* ending) {
    return path.parent_path() / (path.stem().string() + ending);
  };
  std::vector<fs::path> written{path};
  if (purpose == FilePurpose::saveTurntable) written = {beside("_001.png"), beside(".mp4")};
  const bool hasSkin = purpose == FilePurpose::saveSkin || purpose == FilePurpose::saveLitSkin;
  if (hasSkin && formatNamed(FileKind::texturedMesh, path) == FileFormat::obj)
    for (const char* ending : {".mtl", "_colour.png", "_normal.png", "_roughness.png"})
      written.push_back(beside(ending));
  if (hasRecipe(purpose)) written.push_back(fs::path(path).replace_extension(".recipe.json"));
  return written;
}

std::vector<fs::path> replacedFiles(FilePurpose purpose, const fs::path& path) {
  std::vector<fs::path> written = writtenFiles(purpose, path);
  if (purpose == FilePurpose::saveTurntable)  // pictures that are there are refused
    written.erase(written.begin(), written.begin() + 2);
  if (purpose == FilePurpose::saveSequence) {
    written.erase(written.begin());
    const std::vector<fs::path> steps = stepsThere(path);
    written.insert(written.begin(), steps.begin(), steps.end());
  }
  std::error_code error;
  std::erase_if(written, [&](const fs::path& file) { return !fs::exists(file, error); });
  return written;
}

}  // namespace sonoskin::ui
