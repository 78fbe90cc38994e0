#include <algorithm>
#include <array>
#include <cctype>

#include "app/widgets/file_dialog.h"

namespace sonoskin::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 10> kVolumes{".nrrd",   ".nhdr", ".mha", ".mhd", ".nii",
                                               ".nii.gz", ".vtk",  ".dcm", ".vol", ".dat"};
constexpr std::array<const char*, 3> kWrittenVolumes{".nrrd", ".mha", ".nii.gz"};
constexpr std::array<const char*, 5> kMeshes{".ply", ".stl", ".obj", ".glb", ".3mf"};
constexpr std::array<const char*, 2> kPrints{".stl", ".3mf"};
constexpr std::array<const char*, 2> kTextured{".glb", ".obj"};
constexpr std::array<const char*, 1> kPictures{".png"};
constexpr std::array<const char*, 1> kRecipes{".json"};

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

FilePurposeText purposeText(FilePurpose purpose) {
  switch (purpose) {
    case FilePurpose::openVolume:
      return {"Open volume", "Open", false, kVolumes};
    case FilePurpose::openErased:
      return {"Open erased parts", "Open", false, kVolumes};
    case FilePurpose::saveErased:
      return {"Save erased parts", "Save", true, kWrittenVolumes};
    case FilePurpose::openRecipe:
      return {"Open recipe", "Open", false, kRecipes};
    case FilePurpose::saveRecipe:
      return {"Save recipe", "Save", true, kRecipes};
    case FilePurpose::saveMesh:
      return {"Save mesh", "Save", true, kMeshes};
    case FilePurpose::savePrint:
      return {"Save for printing", "Save", true, kPrints};
    case FilePurpose::saveSkin:
      return {"Save surface with skin", "Save", true, kTextured};
    case FilePurpose::saveLitSkin:
      return {"Save surface with skin and light", "Save", true, kTextured};
    case FilePurpose::savePicture:
      return {"Save picture of the 3D view", "Save", true, kPictures};
  }
  return {};
}

bool hasEnding(const std::string& name, std::span<const char* const> endings) {
  const std::string small = lower(name);
  return std::any_of(endings.begin(), endings.end(),
                     [&](const char* ending) { return small.ends_with(ending); });
}

std::vector<FileEntry> listFolder(const fs::path& folder, std::span<const char* const> endings) {
  std::vector<FileEntry> entries;
  for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
    std::error_code error;
    const std::string name = file.path().filename().string();
    if (name.starts_with('.')) continue;
    if (file.is_directory(error)) {
      entries.push_back({name, true, 0});
    } else if (file.is_regular_file(error) && (endings.empty() || hasEnding(name, endings))) {
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
    const auto endings = purposeText(*purpose).endings;
    entries = listFolder(full, allFiles ? std::span<const char* const>() : endings);
    folder = full;
  } catch (const fs::filesystem_error&) {
    complaint = "This folder cannot be read: " + wanted.string();
  }
}

}  // namespace sonoskin::ui
