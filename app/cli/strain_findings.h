#pragma once

#include <filesystem>
#include <string>

#include "cli/stage_options.h"
#include "viscera/live/strain_reading.h"

/// Prints the strain of a heart.
namespace viscera::app::cli {

/// Lines for a reader, with the ranges of healthy adults.
std::string strainText(const live::StrainReading& reading);

/// The bull's eyes of the peaks above the curves, as a PNG. Throws `CannotCreateError`, and `Error` without
/// OpenGL.
void drawStrain(const std::filesystem::path& file, const live::StrainReading& reading,
                const PictureSize& size, bool dark);

} // namespace viscera::app::cli
