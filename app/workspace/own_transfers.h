#pragma once

#include <string>
#include <vector>

#include "render/transfer_presets.h"

namespace sonoskin {

// The person's own transfer functions: files in the folder "transfer" beside the settings (app/document/transfer_file.h).

// ownTransfers: their names, in order.
std::vector<std::string> ownTransfers();
//   errors  as readTransfer
LevelledTransfer ownTransfer(const std::string& name);
// keepTransfer: under a name, in the place of the one that had it.
//   errors  Error (usage): no name: letters, digits, spaces, - and _ are, or a preset of the program has it; as writeTransfer
void keepTransfer(const std::string& name, const LevelledTransfer& transfer);
// forgetTransfer: nothing happens where there is none of that name.
void forgetTransfer(const std::string& name);

}  // namespace sonoskin
