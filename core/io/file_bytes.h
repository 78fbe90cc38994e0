#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace sonoskin {

// fileSize: bytes of an ordinary file.
//   errors  Error: there is none of that name, or it is a folder or a device, or it is empty
std::uintmax_t fileSize(const std::filesystem::path& path);

// readBytes: the whole file, or its first `most` bytes.
//   errors  as fileSize; Error: the file cannot be read
std::vector<std::uint8_t> readBytes(const std::filesystem::path& path, std::uintmax_t most = UINTMAX_MAX);

// readText: the text of a small file, such as a recipe.
//   errors  Error: as fileSize; it is larger than `most` bytes; it cannot be read
std::string readText(const std::filesystem::path& path, std::uintmax_t most = 4u << 20);

// lowerExtension: the extension in small letters, ".nii.gz" taken as one; empty without any.
std::string lowerExtension(const std::filesystem::path& path);

}  // namespace sonoskin
