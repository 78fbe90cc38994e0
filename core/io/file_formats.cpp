#include "core/io/file_formats.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "core/base/error.h"
#include "core/io/header_text.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

enum class Holds { volume, mesh, picture, recipe, session, text };

// Row: a format, and the endings under which it is read and written.
//   keeps          what a written file holds, or where a read one is looked for; for people
//   begins         the mark in its first bytes, from `beginsAt` on; empty: it is known by its name alone
//   prints, skins, points  written for printers, with the maps of the skin, and without triangles
struct Row {
  FileFormat format;
  Holds holds;
  std::string_view name;
  std::vector<std::string> read, written;
  std::string_view keeps;
  std::string_view begins = {};
  std::size_t beginsAt = 0;
  bool prints = false, skins = false, points = false;
};

const std::vector<Row>& rows() {
  using F = FileFormat;
  static const std::vector<Row> all{
      {F::nrrd,
       Holds::volume,
       "NRRD",
       {".nrrd", ".nhdr"},
       {".nrrd"},
       "place, spacing, direction, the probe's beams",
       "NRRD"},
      {F::meta,
       Holds::volume,
       "MetaImage",
       {".mha", ".mhd"},
       {".mha"},
       "place, spacing, direction, the probe's beams"},
      {F::nifti,
       Holds::volume,
       "NIfTI",
       {".nii", ".nii.gz", ".hdr"},
       {".nii.gz"},
       "place, spacing, direction"},
      {F::vtk,
       Holds::volume,
       "VTK",
       {".vtk"},
       {".vtk"},
       "place and spacing; legacy files, written unpacked",
       "# vtk DataFile"},
      {F::dicom,
       Holds::volume,
       "DICOM",
       {".dcm"},
       {},
       "a series: its folder, or one of its files, whatever their names",
       "DICM",
       128},
      {F::kretz,
       Holds::volume,
       "GE Kretz",
       {".vol", ".v00", ".4dv"},
       {},
       "Voluson; samples of beams, or voxels; not packed by wavelets",
       "KRETZFILE"},
      {F::voreen,
       Holds::volume,
       "Voreen",
       {".dat", ".vvd"},
       {},
       "headers of raw files beside them; Inviwo's and QVis' too"},
      {F::raw,
       Holds::volume,
       "raw numbers",
       {".raw", ".bin", ".img"},
       {},
       "what `raw.dims` and its like say; Toshiba's RawData_VolN.bin by the PatientInfo.txt beside it"},
      {F::ply,
       Holds::mesh,
       "PLY",
       {".ply"},
       {".ply"},
       "mm; normals, labels, what the probe sees and what was measured",
       {},
       0,
       false,
       false,
       true},
      {F::stl, Holds::mesh, "STL", {".stl"}, {".stl"}, "mm; triangles alone", {}, 0, true},
      {F::glb, Holds::mesh, "GLB", {".glb", ".gltf"}, {".glb"}, "metres, Y up; normals", {}, 0, false, true},
      {F::obj, Holds::mesh, "OBJ", {".obj"}, {".obj"}, "mm; normals", {}, 0, false, true},
      {F::threeMf, Holds::mesh, "3MF", {".3mf"}, {".3mf"}, "mm; triangles alone", {}, 0, true},
      {F::vtp,
       Holds::mesh,
       "VTP",
       {".vtp"},
       {".vtp"},
       "mm; as PLY, for ParaView and 3D Slicer; legacy .vtk files of polygons are read too"},
      {F::dicomStl,
       Holds::mesh,
       "DICOM Encapsulated STL",
       {},
       {".dcm"},
       "mm; triangles alone; no patient, or the one that is given"},
      {F::png, Holds::picture, "PNG", {}, {".png"}, "pictures"},
      {F::json, Holds::recipe, "JSON", {".json"}, {".json"}, "recipes"},
      {F::session,
       Holds::session,
       "Sonoskin session",
       {".sonoskin"},
       {".sonoskin"},
       "a recipe, the views, and where the volume lies on this machine; as a recipe too"},
      {F::text, Holds::text, "plain text", {}, {".txt"}, "what the window has said, without names of files"}};
  return all;
}

const Row& rowOf(FileFormat format) { return rows()[std::size_t(format)]; }

// Selection: which rows are a kind's, and whether by what is read or by what is written; `one` is a file of it, for
// sentences; `also` is taken beside it.
struct Selection {
  Holds holds;
  bool reads;
  const char* one;
  bool Row::*flag = nullptr;
  std::optional<Holds> also = {};
};
constexpr std::size_t kKinds = 13;
constexpr std::array<Selection, kKinds> kSelections{
    {{Holds::volume, true, "a volume"},
     {Holds::volume, false, "a volume"},
     {Holds::mesh, true, "a mesh"},
     {Holds::mesh, false, "a mesh"},
     {Holds::mesh, false, "a solid to print", &Row::prints},
     {Holds::mesh, false, "a surface with skin", &Row::skins},
     {Holds::picture, false, "a picture"},
     {Holds::recipe, false, "a recipe"},
     {Holds::session, false, "a session"},
     {Holds::volume, true, "a volume", nullptr, Holds::session},
     {Holds::text, false, "a text"},
     {Holds::mesh, false, "a file of points", &Row::points},
     {Holds::recipe, false, "a report", nullptr, Holds::text}}};

const Selection& selectionOf(FileKind kind) { return kSelections[std::size_t(kind)]; }

const std::vector<std::string>& endingsOf(const Row& row, FileKind kind) {
  static const std::vector<std::string> none;
  const Selection& s = selectionOf(kind);
  if ((row.holds != s.holds && row.holds != s.also) || (s.flag && !(row.*s.flag))) return none;
  return s.reads ? row.read : row.written;
}

std::string listed(const std::vector<std::string>& words) {
  if (words.size() < 2) return fmt::format("{}", fmt::join(words, ""));
  return fmt::format("{} or {}", fmt::join(words.begin(), words.end() - 1, ", "), words.back());
}

// What a file is instead, by its name: "{} is a mesh".
std::string instead(FileKind kind, const fs::path& file) {
  for (const FileKind other :
       {FileKind::readVolume, FileKind::readMesh, FileKind::picture, FileKind::recipe, FileKind::session})
    if (selectionOf(other).holds != selectionOf(kind).holds && formatNamed(other, file))
      return fmt::format("{} is {}, not {}", file.string(), selectionOf(other).one, selectionOf(kind).one);
  return fmt::format("{} is not {} of a format that is known here", file.string(), selectionOf(kind).one);
}

Error unreadable(FileKind kind, const fs::path& file) {
  return Error(fmt::format("{}; use {}.", instead(kind, file), formatList(kind)));
}

}  // namespace

std::string_view formatName(FileFormat format) { return rowOf(format).name; }
std::string_view formatKeeps(FileFormat format) { return rowOf(format).keeps; }

const std::vector<std::string>& extensionsOf(FileKind kind) {
  static const std::array<std::vector<std::string>, kKinds> lists = [] {
    std::array<std::vector<std::string>, kKinds> all;
    for (std::size_t k = 0; k < kKinds; ++k)
      for (const Row& row : rows()) {
        const std::vector<std::string>& endings = endingsOf(row, FileKind(k));
        all[k].insert(all[k].end(), endings.begin(), endings.end());
      }
    return all;
  }();
  return lists[std::size_t(kind)];
}

std::vector<std::string> extensionWords(FileKind kind) {
  std::vector<std::string> words = extensionsOf(kind);
  for (std::string& word : words) word.erase(0, 1);
  return words;
}

std::string extensionList(FileKind kind) { return listed(extensionsOf(kind)); }

std::string formatList(FileKind kind) {
  std::vector<std::string> formats;
  for (const Row& row : rows())
    if (const auto& endings = endingsOf(row, kind); !endings.empty())
      formats.push_back(fmt::format("{} ({}{})", row.name, fmt::join(endings, ", "),
                                    row.format == FileFormat::dicom ? ", or its folder" : ""));
  return listed(formats);
}

std::optional<FileFormat> formatNamed(FileKind kind, const fs::path& file) {
  const std::string name = lowerCase(file.filename().string());
  for (const Row& row : rows())
    for (const std::string& ending : endingsOf(row, kind))
      if (name.size() > ending.size() && name.ends_with(ending)) return row.format;
  return {};
}

FileFormat requireFormat(FileKind kind, const fs::path& file) {
  if (const auto format = formatNamed(kind, file)) return *format;
  if (selectionOf(kind).reads) throw unreadable(kind, file);
  throw Error(fmt::format("{} cannot be written: the name of {} ends in {}.", file.string(),
                          selectionOf(kind).one, extensionList(kind)),
              Error::Kind::usage);
}

bool beginsAs(FileFormat format, std::span<const std::uint8_t> start) {
  const Row& row = rowOf(format);
  return !row.begins.empty() && start.size() >= row.beginsAt + row.begins.size() &&
         !std::memcmp(start.data() + row.beginsAt, row.begins.data(), row.begins.size());
}

bool hasMark(std::span<const std::uint8_t> start) {
  return std::ranges::any_of(
      rows(), [&](const Row& row) { return row.holds == Holds::volume && beginsAs(row.format, start); });
}

FileFormat volumeFormat(const fs::path& file, std::span<const std::uint8_t> start) {
  for (const Row& row : rows())
    if (row.holds == Holds::volume && beginsAs(row.format, start)) return row.format;
  const auto named = formatNamed(FileKind::readVolume, file);
  if (!named) throw unreadable(FileKind::readVolume, file);
  require(rowOf(*named).begins.empty(),
          "{} does not begin as {} files do; get a fresh copy, or give it the ending of what it is.",
          file.string(), rowOf(*named).name);
  return *named;
}

std::string formatTable() {
  std::string text = "| | format | read | written | what it keeps |\n|---|---|---|---|---|\n";
  constexpr std::array<const char*, 6> kTitles{"volumes", "meshes",   "pictures",
                                               "recipes", "sessions", "texts"};
  const Row* above = nullptr;
  for (const Row& row : rows()) {
    const bool first = !above || above->holds != row.holds;
    const auto cell = [](const std::vector<std::string>& endings) {
      return endings.empty() ? std::string("-") : fmt::format("{}", fmt::join(endings, ", "));
    };
    text += fmt::format("| {} | {} | {} | {} | {}{}{} |\n", first ? kTitles[std::size_t(row.holds)] : "",
                        row.name, cell(row.read), cell(row.written), row.keeps,
                        row.prints ? "; solids to print" : "",
                        row.skins ? "; with `--bake` the maps of the skin" : "");
    above = &row;
  }
  return text;
}

}  // namespace sonoskin
