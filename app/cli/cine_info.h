#pragma once

#include <optional>
#include <string>

#include "cli/command.h"

namespace viscera::app::cli {

/// Describes the cine study in a folder: a line for each series, with number, plane, place, phases and
/// spacing, and one for each stack. Nothing for what is no DICOM folder, and for a folder with fewer than two
/// series over a heart's cycle, which is a scan. A study that cannot be read, as of two patients, is nothing,
/// too; `warnings` say why. Throws `Cancelled`.
std::optional<Outcome> describeCine(const std::string& folder, CommandContext& context,
                                    std::vector<Text>& warnings);

} // namespace viscera::app::cli
