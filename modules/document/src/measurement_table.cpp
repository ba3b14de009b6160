#include "viscera/document/measurement_table.h"

#include <iomanip>
#include <locale>
#include <ostream>
#include <utility>

#include "viscera/core/atomic_file.h"
#include "viscera/core/text.h"
#include "viscera/document/document.h"

namespace viscera::document {
namespace {

constexpr std::size_t kMostPoints = 3;
constexpr const char* kNoPoint = ",,,,,,,"; ///< Its name and six coordinates.

void writeHeader(std::ostream& out) {
  out << "name,kind,value_at_rest,value_now,unit";
  for (std::size_t i = 1; i <= kMostPoints; ++i) {
    out << ",organ_" << i;
    for (const char* when : {"rest_", ""})
      for (const char* axis : {"x_", "y_", "z_"})
        out << ',' << when << axis << i << "_mm";
  }
  out << '\n';
}

void writeRow(std::ostream& out, const MeasurementRow& row) {
  const MeasurementKind kind = kindOf(row.measurement);
  out << csvField(row.measurement.name) << ',' << nameOf(kind) << ',' << row.values.rest << ','
      << row.values.now << ',' << unitOf(kind);
  for (std::size_t i = 0; i < kMostPoints; ++i) {
    if (i >= row.measurement.points.size()) {
      out << kNoPoint;
      continue;
    }
    out << ',' << csvField(row.organs[i]);
    for (const Vec3& place : {row.measurement.points[i].rest, row.values.places[i]})
      out << ',' << place.x() << ',' << place.y() << ',' << place.z();
  }
  out << '\n';
}

} // namespace

std::vector<MeasurementRow> measurementRows(const DocumentState& state, const PointsOf& pointsOf) {
  std::vector<MeasurementRow> rows;
  for (const Measurement& measurement : *state.measurements) {
    MeasurementRow row{measurement, measure(measurement, state, pointsOf), {}};
    for (const MeasuredPoint& point : measurement.points) {
      const auto organ = point.organ ? state.organ(point.organ) : nullptr;
      row.organs.push_back(organ ? organ->name : std::string());
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

void writeMeasurementTable(const std::filesystem::path& file, const std::vector<MeasurementRow>& rows) {
  writeAtomically(file, [&](std::ostream& out) {
    out.imbue(std::locale::classic());
    writeHeader(out);
    out << std::fixed << std::setprecision(6);
    for (const MeasurementRow& row : rows)
      writeRow(out, row);
  });
}

} // namespace viscera::document
