#include "app/workspace/command_tables.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/workspace/session_actions.h"
#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

using W = Workspace;

bool hasClassified(const W& w) { return w.session.results().classified && !w.session.classifiedIsCoarse(); }

// clang-format off
const Command kCommands[] = {
  {"file.open", "Open...", Menu::file, control(GLFW_KEY_O),
   [](W& w) { w.files.ask(ui::FilePurpose::open, w.settings.folder, ""); }},
  {"file.phantom", "Open phantom", Menu::file, control(GLFW_KEY_P), [](W& w) { w.confirmLoss(tr("Opening the phantom"), [&w] { w.session.openPhantom(); }); }},
  {"file.openSession", "Open session...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::openSession, w.settings.folder, ""); }, nullptr, nullptr, true},
  {"file.saveSession", "Save session", Menu::file, controlShift(GLFW_KEY_S), [](W& w) { saveSession(w); }, hasScan},
  {"file.saveSessionAs", "Save session as...", Menu::file, {}, [](W& w) { askWhereToSave(w); }, hasScan},
  {"file.openRecipe", "Open recipe...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::openRecipe, w.settings.folder, ""); }, nullptr, nullptr, true},
  {"file.saveRecipe", "Save recipe...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::saveRecipe, w.settings.folder, "sonoskin.recipe.json"); }},
  {"file.export", "Export...", Menu::file, control(GLFW_KEY_E), [](W& w) { w.exportShown = true; }, hasScan, nullptr, true},
  {"file.saveMesh", "Save mesh...", Menu::file, control(GLFW_KEY_S),
   [](W& w) { w.files.ask(ui::FilePurpose::saveMesh, w.settings.folder, w.session.proposedName(".ply")); }, hasMesh},
  {"file.saveSequence", "Save a mesh of each time step...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::saveSequence, w.settings.folder, w.session.proposedName(".ply")); }, hasSteps},
  {"file.savePrint", "Save for printing...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::savePrint, w.settings.folder, w.session.proposedName(".stl")); }, hasMesh},
  {"file.saveScan", "Save scan for other programs...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::saveScan, w.settings.folder, "scan.nrrd"); }, hasScan, nullptr, true},
  {"file.saveClassified", "Save classified volume...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::saveClassified, w.settings.folder, "classified.nrrd"); }, hasClassified},
  {"file.saveSkin", "Save surface with skin...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::saveSkin, w.settings.folder, w.session.proposedName(".glb")); }, showsSkin},
  {"file.saveLitSkin", "Save surface with skin and light...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::saveLitSkin, w.settings.folder, w.session.proposedName(".glb")); }, showsSkin},
  {"file.savePicture", "Save picture...", Menu::file, key(GLFW_KEY_F12),
   [](W& w) { w.pictureRequest = PictureRequest{false}; }, hasScan},
  {"file.saveTurntable", "Save turntable...", Menu::file, {}, [](W& w) { w.pictureRequest = PictureRequest{true}; }, hasScan},
  {"file.contactSheet", "Contact sheet...", Menu::file, {}, [](W& w) { w.sheetShown = true; }, hasScan},
  {"file.openErased", "Open erased parts...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::openErased, w.settings.folder, ""); }, hasScan, nullptr, true},
  {"file.saveErased", "Save erased parts...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::saveErased, w.settings.folder, w.session.proposedName(".erased.nrrd")); }, hasErased},
  {"file.quit", "Quit", Menu::file, control(GLFW_KEY_Q), [](W& w) { w.confirmLoss(tr("Quitting"), [&w] { w.quit = true; }); }, nullptr, nullptr, true},
};
// clang-format on

}  // namespace

std::span<const Command> fileCommands() { return kCommands; }

}  // namespace sonoskin
