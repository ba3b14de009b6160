#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "viscera/coordinates/measure/scene.h"

/// What `viscera properties` and `viscera reproduce` try the coordinate systems on.
namespace viscera::app::cli {

/// How many handles lie around the line of `resources/lines`, for each of its tables.
inline constexpr int kLineHandles[] = {9, 10, 11, 14, 15, 26};

/// The line surrounded by that many handles, one of `kLineHandles`.
coordinates::Scene lineScene(int handles);

/// `points` vertices of a sample organ's surface, spread evenly, among handles as the program places them:
/// `handles` of them, in three groups along the organ, whose regions hold it.
coordinates::Scene organScene(const std::string& organ, int handles, int points,
                              const Surroundings& surroundings, Progress& progress);

} // namespace viscera::app::cli
