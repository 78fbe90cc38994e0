#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace sonoskin::ui {

// withoutNames: a sentence without names of files and folders, which may be a patient's; "[file]" stands for each.
//   files  those that a person has chosen: their names may have blanks. Others are known by their slashes and endings.
std::string withoutNames(std::string sentence, std::span<const std::filesystem::path> files);

}  // namespace sonoskin::ui
