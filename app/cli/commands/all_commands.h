#pragma once

#include <memory>

#include "cli/command.h"

/// Functions that make the subcommands of `viscera`, in the order in which the help lists them.
namespace viscera::app::cli {

std::unique_ptr<Command> infoCommand();
std::unique_ptr<Command> systemsCommand();
std::unique_ptr<Command> sampleCommand();
std::unique_ptr<Command> convertCommand();
std::unique_ptr<Command> handlesCommand();
std::unique_ptr<Command> bindCommand();
std::unique_ptr<Command> deformCommand();
std::unique_ptr<Command> stressCommand();
std::unique_ptr<Command> elasticityCommand();
std::unique_ptr<Command> playCommand();
std::unique_ptr<Command> circulateCommand();
std::unique_ptr<Command> trackCommand();
std::unique_ptr<Command> strainCommand();
std::unique_ptr<Command> lessonCommand();
std::unique_ptr<Command> segmentCommand();
std::unique_ptr<Command> probeCommand();
std::unique_ptr<Command> measureCommand();
std::unique_ptr<Command> warpCommand();
std::unique_ptr<Command> phantomCommand();
std::unique_ptr<Command> renderCommand();
std::unique_ptr<Command> propertiesCommand();
std::unique_ptr<Command> reproduceCommand();
std::unique_ptr<Command> reportCommand();
std::unique_ptr<Command> dicomCommand();
std::unique_ptr<Command> commandsCommand();
std::unique_ptr<Command> referenceCommand();
std::unique_ptr<Command> archiveCommand();

} // namespace viscera::app::cli
