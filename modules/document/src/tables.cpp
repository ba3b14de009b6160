#include "viscera/document/tables.h"

#include <cmath>
#include <iomanip>
#include <locale>
#include <ostream>
#include <sstream>
#include <utility>

#include "viscera/anatomy/part.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/text.h"
#include "viscera/document/document.h"
#include "viscera/geometry/volume.h"

namespace viscera::document {
namespace {

constexpr double kMm2PerCm2 = 100;

constexpr std::size_t kMostPoints = 3;
constexpr const char* kNoPoint = ",,,,,,,"; ///< Its name and six coordinates.

void writeRow(std::ostream& out, const PosedOrgan& posed) {
  const Organ& organ = *posed.organ;
  const Triangles& triangles = organ.mesh->triangles;
  out << csvField(organ.name) << ',' << posed.points.rows() << ',' << triangles.rows() << ','
      << (organ.closed() ? "yes" : "no") << ',';
  if (organ.closed()) {
    const double rest = organ.restVolumeMm3 / kMm3PerMl;
    const double now = geometry::volume(posed.points, triangles) / kMm3PerMl;
    out << rest << ',' << now << ',' << now - rest << ',' << 100 * (now - rest) / rest << ',';
  } else {
    out << ",,,,";
  }
  const Bounds box = boundsOf(posed.points);
  const Vec3 size = box.high - box.low;
  out << geometry::area(posed.points, triangles) / kMm2PerCm2 << ',' << size.x() << ',' << size.y() << ','
      << size.z() << ',' << (posed.points - organ.mesh->points).rowwise().norm().maxCoeff() << ',';
  if (organ.closed())
    out << organ.restVolumeMm3 / kMm3PerMl;
  out << ',' << anatomy::chamberKey(organ.name) << '\n';
}

std::string measurementHeader() {
  std::ostringstream out;
  out << "name,kind,value_at_rest,value_now,unit";
  for (std::size_t i = 1; i <= kMostPoints; ++i) {
    out << ",organ_" << i;
    for (const char* when : {"rest_", ""})
      for (const char* axis : {"x_", "y_", "z_"})
        out << ',' << when << axis << i << "_mm";
  }
  out << ",standard_deviation,minimum,maximum,voxels,area_mm2,volume_ml";
  return out.str();
}

/// Nothing where there is no number.
void writeNumber(std::ostream& out, double value) {
  if (std::isfinite(value))
    out << value;
}

/// Writes the statistics of a region of the scan other than the mean.
void writeRegion(std::ostream& out, const MeasurementRow& row) {
  const auto region = regionOf(row.measurement);
  if (const auto& known = row.values.region; known && known->count > 0)
    out << ',' << known->deviation << ',' << known->minimum << ',' << known->maximum << ',' << known->count;
  else
    out << (region && known ? ",,,,0" : ",,,,");
  out << ',';
  if (region && row.measurement.kind == MeasurementKind::rectangle)
    out << std::get<medical_io::RectangleRegion>(*region).areaMm2();
  out << ',';
  if (region && row.measurement.kind == MeasurementKind::sphere)
    out << std::get<medical_io::SphereRegion>(*region).volumeMl();
}

void writeRow(std::ostream& out, const MeasurementRow& row) {
  out << csvField(row.measurement.name) << ',' << nameOf(row.measurement.kind) << ',';
  writeNumber(out, row.values.rest);
  out << ',';
  writeNumber(out, row.values.now);
  out << ',' << csvField(row.unit);
  for (std::size_t i = 0; i < kMostPoints; ++i) {
    if (i >= row.measurement.points.size()) {
      out << kNoPoint;
      continue;
    }
    out << ',' << csvField(row.organs[i]);
    for (const Vec3& place : {row.measurement.points[i].rest, row.values.places[i]})
      out << ',' << place.x() << ',' << place.y() << ',' << place.z();
  }
  writeRegion(out, row);
  out << '\n';
}

template <class Row>
void writeTable(const std::filesystem::path& file, const std::string& header, const std::vector<Row>& rows) {
  writeAtomically(file, [&](std::ostream& out) {
    out.imbue(std::locale::classic());
    out << header << '\n' << std::fixed << std::setprecision(6);
    for (const Row& row : rows)
      writeRow(out, row);
  });
}

} // namespace

void writeOrganTable(const std::filesystem::path& file, const std::vector<PosedOrgan>& organs) {
  writeTable(file,
             "name,vertices,triangles,closed,rest_ml,volume_ml,change_ml,change_percent,area_cm2,size_x_mm,"
             "size_y_mm,size_z_mm,largest_displacement_mm,volume_rest_ml,chamber",
             organs);
}

std::vector<MeasurementRow> measurementRows(const DocumentState& state, const PointsOf& pointsOf,
                                            const TissueMotion& tissue) {
  std::vector<MeasurementRow> rows;
  for (const Measurement& measurement : *state.measurements) {
    MeasurementRow row{
        measurement, measure(measurement, state, pointsOf, nullptr, tissue), unitOf(measurement, state), {}};
    for (const MeasuredPoint& point : measurement.points) {
      const auto organ = point.organ ? state.organ(point.organ) : nullptr;
      row.organs.push_back(organ ? organ->name : std::string());
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

void writeMeasurementTable(const std::filesystem::path& file, const std::vector<MeasurementRow>& rows) {
  writeTable(file, measurementHeader(), rows);
}

} // namespace viscera::document
