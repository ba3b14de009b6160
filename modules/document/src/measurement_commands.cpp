#include "viscera/document/measurement_commands.h"

#include <algorithm>
#include <utility>

#include "viscera/document/edit.h"

namespace viscera::document {
namespace {

constexpr const char* kKind = "measurement";

/// The point as the organ's surface has it.
MeasuredPoint sound(const DocumentState& state, const MeasuredPoint& point) {
  if (!point.organ) {
    MeasuredPoint fixed;
    fixed.rest = point.rest;
    return fixed;
  }
  return surfacePoint(*edit::requireOrgan(state, point.organ), point.triangle, point.weights);
}

std::string freeName(const MeasurementList& measurements, MeasurementKind kind) {
  const std::string word = kind == MeasurementKind::distance ? "Distance " : "Angle ";
  const auto taken = [&](const std::string& name) {
    return std::any_of(measurements.begin(), measurements.end(),
                       [&name](const Measurement& other) { return other.name == name; });
  };
  int number = 1;
  while (taken(word + std::to_string(number)))
    ++number;
  return word + std::to_string(number);
}

} // namespace

Command addMeasurement(std::vector<MeasuredPoint> points, std::string name) {
  const std::string what = points.size() == 2 ? "Measure distance" : "Measure angle";
  return edit::onPart(what, &DocumentState::measurements,
                      [points = std::move(points), name = std::move(name)](
                          MeasurementList& measurements, const DocumentState& state, IdSource& ids) {
                        if (points.size() != 2 && points.size() != 3)
                          throw UsageError("A distance needs two points and an angle three");
                        Measurement made;
                        for (const MeasuredPoint& point : points)
                          made.points.push_back(sound(state, point));
                        made.name = name.empty() ? freeName(measurements, kindOf(made)) : name;
                        made.id = ids.next<MeasurementId>();
                        measurements.push_back(std::move(made));
                      });
}

Command moveMeasuredPoint(MeasurementId measurement, std::size_t index, MeasuredPoint point) {
  return edit::onPart(
      "Move measured point", &DocumentState::measurements,
      [=](MeasurementList& measurements, const DocumentState& state, IdSource&) {
        Measurement& changed = edit::require(measurements, measurement, kKind);
        if (index >= changed.points.size())
          throw UsageError("There is no such point", changed.name);
        changed.points[index] = sound(state, point);
      },
      "measure/" + std::to_string(measurement.value) + "/" + std::to_string(index));
}

Command renameMeasurement(MeasurementId measurement, std::string name) {
  return edit::onPart("Rename measurement", &DocumentState::measurements,
                      [measurement, name = std::move(name)](MeasurementList& measurements) {
                        edit::require(measurements, measurement, kKind).name = name;
                      });
}

Command removeMeasurements(std::vector<MeasurementId> ids) {
  const std::string name = edit::counted("Remove", ids.size(), kKind);
  return edit::onPart(
      name, &DocumentState::measurements,
      [ids = std::move(ids)](MeasurementList& measurements) { edit::remove(measurements, ids, kKind); });
}

Command removeAllMeasurements() {
  return edit::onPart("Remove all measurements", &DocumentState::measurements,
                      [](MeasurementList& measurements) { measurements.clear(); });
}

} // namespace viscera::document
