#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/io/file_formats.h"
#include "core/io/mesh_placement.h"

namespace sonoskin::ui {

enum class FilePurpose {
  open,
  findVolume,
  openSession,
  saveSession,
  openErased,
  saveErased,
  openRecipe,
  saveRecipe,
  saveMesh,
  saveSequence,
  savePrint,
  saveScan,
  saveClassified,
  saveSkin,
  saveLitSkin,
  savePicture,
  saveMessages,
  saveTurntable,
  saveSheet,
  savePoints,
  saveThinned,
  saveReport
};

// FilePurposeText: how the dialog looks for a purpose, and which files it lists and writes.
struct FilePurposeText {
  const char* title;
  const char* button;
  bool save;
  FileKind kind;
};
FilePurposeText purposeText(FilePurpose purpose);

// FileChoice: what the person chose.
//   placement  of a mesh
struct FileChoice {
  FilePurpose purpose;
  std::filesystem::path path;
  MeshPlacement placement{};
};

// FileEntry: a line of the list.
struct FileEntry {
  std::string name;
  bool folder = false;
  std::uintmax_t bytes = 0;
};

// listFolder: folders first, then the files whose ending is one of a kind's (none: all), each by name; hidden ones left
// out.
//   errors  std::filesystem::filesystem_error: the folder cannot be read
std::vector<FileEntry> listFolder(const std::filesystem::path& folder, std::optional<FileKind> kind);

// FileDialog: asks for a file, in the window itself.
struct FileDialog {
  std::optional<FilePurpose> purpose;  // empty: closed
  bool opening = false;
  std::filesystem::path folder;
  std::string name;
  std::string complaint;  // what is wrong with the choice
  bool allFiles = false;
  bool replaceAsked = false;  // the next press on Save replaces the file
  std::vector<FileEntry> entries;

  // ask: opens the dialog. Without a folder it starts in the current one.
  void ask(FilePurpose purpose, const std::filesystem::path& folder, const std::string& name);
  void enter(const std::filesystem::path& folder);
};

// writtenFiles: all that is written for a purpose: the file, the recipe, material and pictures beside it; of a turntable the
// first picture and the film.
std::vector<std::filesystem::path> writtenFiles(FilePurpose purpose, const std::filesystem::path& path);

// replacedFiles: what is there already of it, and of the surfaces of a sequence.
std::vector<std::filesystem::path> replacedFiles(FilePurpose purpose, const std::filesystem::path& path);

// accept: the file of the name that stands in the dialog; or nothing, and what is wrong with it as a complaint. A name
// without an ending gets the usual one; one with another format's is refused.
std::optional<std::filesystem::path> accept(FileDialog& dialog);

// drawFileDialog: draws it where it is open; gives the choice in the frame in which it is made.
std::optional<FileChoice> drawFileDialog(FileDialog& dialog);

}  // namespace sonoskin::ui
