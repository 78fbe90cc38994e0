#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// The one table of file formats: readers and writers choose by it, and dialogs, help, sentences about wrong files and
// README name what it holds.
namespace sonoskin {

// In the order of the table.
enum class FileFormat {
  nrrd,
  meta,
  nifti,
  vtk,
  dicom,
  kretz,
  voreen,
  raw,
  ply,
  stl,
  glb,
  obj,
  threeMf,
  vtp,
  dicomStl,
  png,
  json,
  session,
  text
};

// FileKind: what a file is wanted for.
//   printedMesh   a solid for a printer
//   texturedMesh  a surface with the maps of its skin
//   text          words for people
//   opened        what the window opens: a volume, or a session with one
//   points        places and normals without triangles
//   report        what was made, for programs or for people
enum class FileKind {
  readVolume,
  writtenVolume,
  readMesh,
  writtenMesh,
  printedMesh,
  texturedMesh,
  picture,
  recipe,
  session,
  opened,
  text,
  points,
  report
};

// formatName: for people: "MetaImage".
std::string_view formatName(FileFormat format);

// formatKeeps: what a written file holds, for people: "mm; triangles alone".
std::string_view formatKeeps(FileFormat format);

// extensionsOf: all endings of a kind, in small letters with their dots; the first is the usual one.
const std::vector<std::string>& extensionsOf(FileKind kind);
// extensionWords: the same without dots, as --export has them.
std::vector<std::string> extensionWords(FileKind kind);
// extensionList: the same for a sentence: ".nrrd, .mha, .nii.gz or .vtk".
std::string extensionList(FileKind kind);
// formatList: the formats with their endings, for a sentence: "NRRD (.nrrd, .nhdr), ... or DICOM (.dcm, or its
// folder)".
std::string formatList(FileKind kind);

// formatNamed: the format that the ending of a file's name stands for; nothing where it is none of the kind's, or the
// whole name.
std::optional<FileFormat> formatNamed(FileKind kind, const std::filesystem::path& file);
// requireFormat: the same, of a file that is about to be read or written.
//   errors  Error (usage where it would be written): the ending is none of the kind's; the sentence names those that are
FileFormat requireFormat(FileKind kind, const std::filesystem::path& file);

// volumeFormat: the format of a volume file, by its first bytes where the format has a mark, else by its name.
//   input   start  the first bytes of the file, 132 where it has so many
//   errors  Error: none that is known here; the sentence names those that are
FileFormat volumeFormat(const std::filesystem::path& file, std::span<const std::uint8_t> start);
// hasMark: whether a file begins as any volume of a format that has a mark.
bool hasMark(std::span<const std::uint8_t> start);
// beginsAs: whether a file begins with the mark of a format that has one.
bool beginsAs(FileFormat format, std::span<const std::uint8_t> start);

// formatTable: all formats, what is read, written and kept, as a Markdown table for README.
std::string formatTable();

}  // namespace sonoskin
