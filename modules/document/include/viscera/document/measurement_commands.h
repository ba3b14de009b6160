#pragma once

#include <string>
#include <vector>

#include "viscera/document/command.h"

/// Commands that add, change and remove measurements. All throw `UsageError` for measurements that are not
/// there and for numbers of points that measure nothing, `DataError` for points that are not on the surface
/// they name.
namespace viscera::document {

/// Measures: two points are a distance, three the angle at the middle one. Without a name it is called
/// "Distance 1", or the next number that is free.
Command addMeasurement(std::vector<MeasuredPoint> points, std::string name = {});

/// Measures what `wanted` says, of whose id nothing is taken; without a name as above. A region's points are
/// taken off their organs, and a rectangle's second corner is brought into the slice of its first.
Command addMeasurement(Measurement wanted);

/// Puts one of its points elsewhere. Moves of one point one after the other are one undo step. A sphere's
/// middle takes the sphere along, and a rectangle stays flat: both corners go to the slice of the one that
/// is moved.
Command moveMeasuredPoint(MeasurementId measurement, std::size_t index, MeasuredPoint point);

Command renameMeasurement(MeasurementId measurement, std::string name);
Command removeMeasurements(std::vector<MeasurementId> measurements);
Command removeAllMeasurements();

} // namespace viscera::document
