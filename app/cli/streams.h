#pragma once

#include <string>

namespace sonoskin {

// BrokenPipe: whoever read the result has gone; the program ends without a word.
struct BrokenPipe {};

// prepareStreams: for the begin of the program. Standard streams that are closed become /dev/null, so that no file that is
// opened later takes their place; a closed pipe or a file that may not grow is an error of the write, not the end.
void prepareStreams();

// writeResult: text on standard output, all of it.
//   errors  BrokenPipe; Error (system): it could not be written
void writeResult(const std::string& text);

}  // namespace sonoskin
