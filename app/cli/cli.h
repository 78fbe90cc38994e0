#pragma once

namespace sonoskin {

// runCommandLine: the whole program: reads the command line and runs the command, or opens the window.
//   output   exit status: 0 done, 2 wrong usage, 3 bad input, 4 cancelled, 1 anything else; the last four with one
//            line "sonoskin: error: ..." on standard error
//   threads  call once, on the main thread: it takes over SIGINT and SIGTERM while a command runs
int runCommandLine(int argc, char** argv);

}  // namespace sonoskin
