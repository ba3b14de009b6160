#pragma once

#include <string>
#include <vector>

#include "viscera/document/command.h"

/// Commands that add, change and remove measurements. All throw `UsageError` for measurements that are not
/// there and for numbers of points that measure nothing, `DataError` for points that are not on the surface
/// they name.
namespace viscera::document {

/// Adds a measurement: two points give a distance, three the angle at the middle one. Without a name it is
/// called "Distance 1", or the next number that is free.
Command addMeasurement(std::vector<MeasuredPoint> points, std::string name = {});

/// Adds the measurement `wanted`, with a new id; without a name as above. Points of a region are detached
/// from organs, and a rectangle's second corner is moved into the slice of its first.
Command addMeasurement(Measurement wanted);

/// Measures the gap of two organs, wherever they are nearest in each pose; it is named after both. Throws
/// `UsageError` for one organ twice.
Command addGap(OrganId from, OrganId to);

/// Moves one of its points, but not those of a gap. Successive moves of one point are one undo step. Moving a
/// sphere's middle moves the whole sphere, and a rectangle stays in one slice: both corners move to the slice
/// of the moved one.
Command moveMeasuredPoint(MeasurementId measurement, std::size_t index, MeasuredPoint point);

Command renameMeasurement(MeasurementId measurement, std::string name);
Command removeMeasurements(std::vector<MeasurementId> measurements);
Command removeAllMeasurements();

} // namespace viscera::document
