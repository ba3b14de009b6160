#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "viscera/document/measured_values.h"
#include "viscera/document/organ.h"

/// Writes volumes of organs and measurements as comma-separated values.
namespace viscera::document {

/// An organ and its points in the present pose.
struct PosedOrgan {
  std::shared_ptr<const Organ> organ;
  Points points; ///< `n x 3`, mm, as many as its mesh has.
};

/// Writes volumes and sizes of organs as comma-separated values, one row each: `name`, `vertices`,
/// `triangles`, `closed` (yes or no), `rest_ml`, `volume_ml`, `change_ml`, `change_percent` (empty for an
/// open surface), `area_cm2`, `size_x_mm`, `size_y_mm`, `size_z_mm`, `largest_displacement_mm`; all but
/// `rest_ml` in the pose; `volume_rest_ml`, the same as `rest_ml` under the name that JSON and Python have,
/// and `chamber` ("lv", "rv", "la", "ra", or empty). Six decimals, always with a point. A reader sees the old
/// file or the whole new one. Throws `CannotCreateError`.
void writeOrganTable(const std::filesystem::path& file, const std::vector<PosedOrgan>& organs);

/// A measurement with its value, for one row of a table.
struct MeasurementRow {
  Measurement measurement;
  MeasuredValues values;
  std::string unit;
  std::vector<std::string> organs; ///< The names of its points' organs; empty for a place that stays.
};

/// The rows of all measurements of a document, in their order; `tissue` as for `measure`.
std::vector<MeasurementRow> measurementRows(const DocumentState& state, const PointsOf& pointsOf,
                                            const TissueMotion& tissue = {});

/// Writes measurements as comma-separated values, one row each: `name`, `kind` (distance, angle, rectangle or
/// sphere), `value_at_rest`, `value_now` (of a rectangle or a sphere the mean), `unit` (mm, deg, or the
/// scan's), and for each of three points `organ_1`, its place at rest `rest_x_1_mm`, `rest_y_1_mm`,
/// `rest_z_1_mm` and now `x_1_mm`, `y_1_mm`, `z_1_mm` (LPS); the fields of a point that is not there are
/// empty. Of a rectangle or a sphere also `standard_deviation`, `minimum`, `maximum`, `voxels`, `area_mm2` or
/// `volume_ml`; empty for the others, and without a scan. Six decimals, always with a point. A reader sees
/// the old file or the whole new one. Throws `CannotCreateError`.
void writeMeasurementTable(const std::filesystem::path& file, const std::vector<MeasurementRow>& rows);

} // namespace viscera::document
