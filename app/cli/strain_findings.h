#pragma once

#include <string>

#include "viscera/live/strain_reading.h"

/// Prints the strain of a heart.
namespace viscera::app::cli {

/// Lines for a reader, with the ranges of healthy adults.
std::string strainText(const live::StrainReading& reading);

} // namespace viscera::app::cli
