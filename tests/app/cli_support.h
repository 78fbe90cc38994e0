#pragma once

#include <string>
#include <vector>

#include "tests/support/program.h"
#include "tests/support/temp_folder.h"

namespace sonoskin::test {

// sonoskin: runs the program to its end with these arguments.
inline ProgramResult sonoskin(const std::vector<std::string>& arguments) {
  const TempFolder output;
  return RunningProgram(SONOSKIN_PROGRAM, arguments, output.path()).wait();
}

// kSmall: a simulated scan and a surface of it that a run finishes in a second or two.
inline const std::vector<std::string> kSmall{"--phantom.dims", "117x64x31", "--mesh.resolution", "60"};

// joined: a command and the options of a small scan.
inline std::vector<std::string> withSmall(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), kSmall.begin(), kSmall.end());
  return arguments;
}

}  // namespace sonoskin::test
