#include <iostream>

#include "cli/command_line.h"
#include "window/run_window.h"

int main(int argc, char** argv) {
  using namespace viscera::app;
  return cli::runCommandLine(argc, argv, std::cout, std::cerr, [&](const WindowOptions& options) {
    int windowArgc = 1; // Our own options are not Qt's.
    return runWindow(windowArgc, argv, options);
  });
}
