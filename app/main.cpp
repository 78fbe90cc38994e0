#include "app/cli/cli.h"

int main(int argc, char** argv) { return sonoskin::runCommandLine(argc, argv); }
