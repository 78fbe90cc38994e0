#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/widgets/file_dialog.h"
#include "app/workspace/workspace.h"
#include "core/io/mesh_placement.h"

namespace sonoskin::ui {

// ExportItem: something that can be written.
//   id         "mesh", for tests
//   purpose    as the file dialog has it, with its formats
//   name       that is proposed, without an ending
//   available  whether it is there; `missing` says what to do where it is not
struct ExportItem {
  const char *id, *title, *help;
  FilePurpose purpose;
  const char* name;
  bool (*available)(const Workspace&);
  const char* missing;
};
std::span<const ExportItem> exportItems();

// ExportFormat: one that an item can be written in.
//   ending  ".ply"; keeps: what such a file holds, in some words
struct ExportFormat {
  std::string ending, name, keeps;
};
std::vector<ExportFormat> exportFormats(const ExportItem& item);

// ExportPlan: what a person asks for.
//   name  with its ending, which tells the format
struct ExportPlan {
  std::size_t item = 0;
  std::string name = "surface.ply";
  std::filesystem::path folder;
  MeshPlacement placement;

  const ExportItem& what() const { return exportItems()[item]; }
  std::filesystem::path path() const { return folder / name; }
};

// chooseItem: another thing to write, under its own name.
void chooseItem(ExportPlan& plan, std::size_t item);
// chooseEnding: another format; the name keeps its stem.
void chooseEnding(ExportPlan& plan, const std::string& ending);
// endingOf: that of the name where it is one of the item's formats; else empty.
std::string endingOf(const ExportPlan& plan);

// placementChoosable: whether frame and unit are a person's to choose. placementText: what they are, for people: "Millimetres,
// LPS"; empty where nothing is placed.
bool placementChoosable(const ExportPlan& plan);
std::string placementWords(const ExportPlan& plan);

// ExportFile: one of those that will be there afterwards; `more`: up to which others, as "face_072.png".
struct ExportFile {
  std::string name, more;
  bool exists = false;
};
// exportFiles: all that will be written, the one of the name first.
std::vector<ExportFile> exportFiles(const ExportPlan& plan, const PictureFormat& pictures);

// complaintOf: what is wrong with the plan, a sentence; empty where nothing is.
std::string complaintOf(const ExportPlan& plan, const Workspace& workspace);

// exportCommand: the command that writes the same from the scan and the recipe that is written beside.
std::string exportCommand(const ExportPlan& plan, const Workspace& workspace);

}  // namespace sonoskin::ui
