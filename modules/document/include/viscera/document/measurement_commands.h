#pragma once

#include <string>
#include <vector>

#include "viscera/document/command.h"

/// Commands that change what is measured. All throw `UsageError` for measurements that are not there and for
/// numbers of points that measure nothing, `DataError` for points that are not on the surface they name.
namespace viscera::document {

/// Measures: two points are a distance, three the angle at the middle one. Without a name it is called
/// "Distance 1", or the next number that is free.
Command addMeasurement(std::vector<MeasuredPoint> points, std::string name = {});

/// Puts one of its points elsewhere. Moves of one point one after the other are one undo step.
Command moveMeasuredPoint(MeasurementId measurement, std::size_t index, MeasuredPoint point);

Command renameMeasurement(MeasurementId measurement, std::string name);
Command removeMeasurements(std::vector<MeasurementId> measurements);
Command removeAllMeasurements();

} // namespace viscera::document
