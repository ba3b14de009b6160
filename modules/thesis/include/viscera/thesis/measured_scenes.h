#pragma once

#include <memory>
#include <string>

#include "viscera/coordinates/measure/scene.h"
#include "viscera/core/progress.h"
#include "viscera/sample_organs/sample_organ.h"

/// The test scenes of `viscera properties` and `viscera reproduce`.
namespace viscera::thesis {

/// How many handles lie around the line of `resources/lines`, for each of its tables.
inline constexpr int kLineHandles[] = {9, 10, 11, 14, 15, 26};

/// The line surrounded by that many handles, one of `kLineHandles`; throws `UsageError` for another number.
coordinates::Scene lineScene(int handles);

/// The outer surface of a sample organ, "heart@low". Throws as `sample_organs::sampleOrgan`.
std::shared_ptr<const geometry::TriangleMesh>
outerSurface(const std::string& organ, const sample_organs::SampleLibrary& samples, Progress& progress);

/// `points` vertices of a sample organ's surface, spread evenly, among handles as the program places them:
/// `handles` of them, in three groups along the organ, whose regions hold it. Throws as `outerSurface`.
coordinates::Scene organScene(const std::string& organ, int handles, int points,
                              const sample_organs::SampleLibrary& samples, Progress& progress);

} // namespace viscera::thesis
