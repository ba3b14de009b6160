#pragma once

#include <memory>
#include <vector>

#include "cli/command.h"

namespace viscera::app::cli {

/// A new instance of every subcommand, in the order in which the help shows them.
std::vector<std::unique_ptr<Command>> allCommands();

} // namespace viscera::app::cli
