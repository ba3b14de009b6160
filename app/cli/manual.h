#pragma once

#include <string>

#include "cli/shell_completion.h"

namespace viscera::app::cli {

/// The manual page (section 1, in roff) of the program or of one of its subcommands `app`, made from the same
/// options, types, defaults and descriptions that `--help` prints.
std::string manualPage(const CLI::App& app);

/// Writes `man1/viscera.1`, `man1/viscera-NAME.1` for each subcommand, `bash/viscera` and `zsh/_viscera`
/// below `folder`. Throws CannotCreateError.
void writeManual(const CLI::App& program, const ValueWords& words, const std::string& folder);

} // namespace viscera::app::cli
