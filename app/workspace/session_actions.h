#pragma once

#include <filesystem>
#include <functional>
#include <vector>

namespace sonoskin {

struct Workspace;

// What a person does with session files and with whatever else can be opened.

// saveSession: where it was saved or opened last; else the person is asked where. `then` is called when it is written.
void saveSession(Workspace& workspace, std::function<void()> then = {});
// askWhereToSave: opens the dialog for it.
void askWhereToSave(Workspace& workspace, std::function<void()> then = {});
// saveSessionTo: what the dialog answered.
void saveSessionTo(Workspace& workspace, const std::filesystem::path& path);

// openAny: a volume, session or recipe, by its name, after a question where work would be lost; what is none of these is told
// what it is.
void openAny(Workspace& workspace, const std::filesystem::path& path);

// openRecipe: a recipe whatever its name, after a question.
void openRecipe(Workspace& workspace, const std::filesystem::path& path);

// takeDropped: what was dropped on the window; of several files the person chooses one.
void takeDropped(Workspace& workspace, const std::vector<std::filesystem::path>& files);

// openFound: goes on with the session whose volume was not found, with the one that the person chose.
void openFound(Workspace& workspace, const std::filesystem::path& volume);

// takeInOpened: what follows from what the session has opened since the last call: views of a session, recent files, and
// what the person has to be asked. Once a frame, after the views were reset for another scan.
void takeInOpened(Workspace& workspace);

}  // namespace sonoskin
