#include "app/workspace/own_transfers.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "app/document/transfer_file.h"
#include "app/workspace/settings.h"
#include "core/base/error.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 60;

fs::path folder() { return settingsFile().parent_path() / "transfer"; }
fs::path fileOf(const std::string& name) { return folder() / (name + ".json"); }

// Letters of other languages are bytes above 127.
bool isName(const std::string& name) {
  const auto fits = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte > 127 || std::isalnum(byte) || c == ' ' || c == '-' || c == '_';
  };
  return !name.empty() && name.size() <= kLongestName && name.front() != ' ' && name.back() != ' ' &&
         std::ranges::all_of(name, fits);
}

}  // namespace

std::vector<std::string> ownTransfers() {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder(), error))
    if (const fs::path& file = entry.path(); file.extension() == ".json" && isName(file.stem().string()))
      names.push_back(file.stem().string());
  std::ranges::sort(names);
  return names;
}

LevelledTransfer ownTransfer(const std::string& name) { return readTransfer(fileOf(name)); }

void keepTransfer(const std::string& name, const LevelledTransfer& transfer) {
  if (!isName(name))
    throw Error("That is no name for colours; give letters, digits, spaces, - and _.", Error::Kind::usage);
  if (findTransferPreset(name))
    throw Error("The program's own colours keep their names; give another one.", Error::Kind::usage);
  writeTransfer(fileOf(name), transfer);
}

void forgetTransfer(const std::string& name) {
  std::error_code ignored;
  if (isName(name)) fs::remove(fileOf(name), ignored);
}

}  // namespace sonoskin
