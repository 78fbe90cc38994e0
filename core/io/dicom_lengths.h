#pragma once

#include <filesystem>

namespace sonoskin {

// checkDicomLengths: refuses a DICOM file with an element that is longer than what is left of the file, which
// makes GDCM take up to 4 GB of memory (CVE-2026-3650). Looks at every element with an explicit type, inside
// sequences too; stops looking where types are implicit within a sequence or the file is deflated.
//   errors  Error: such an element, or the file ends within one
void checkDicomLengths(const std::filesystem::path& path);

}  // namespace sonoskin
