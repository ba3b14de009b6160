#include "viscera/document/measurement_commands.h"

#include <algorithm>
#include <utility>

#include "viscera/document/edit.h"

namespace viscera::document {
namespace {

DocumentState withMeasurements(DocumentState state, MeasurementList measurements) {
  state.measurements = std::make_shared<const MeasurementList>(std::move(measurements));
  return state;
}

Measurement& requireMeasurement(MeasurementList& measurements, MeasurementId id) {
  for (Measurement& measurement : measurements)
    if (measurement.id == id)
      return measurement;
  throw UsageError("There is no such measurement any more", "measurement " + std::to_string(id.value));
}

/// The point as the organ's surface has it.
MeasuredPoint sound(const DocumentState& state, const MeasuredPoint& point) {
  if (!point.organ) {
    MeasuredPoint fixed;
    fixed.rest = point.rest;
    return fixed;
  }
  const auto organ = state.organ(point.organ);
  if (!organ)
    throw UsageError("There is no such organ any more", "organ " + std::to_string(point.organ.value));
  return surfacePoint(*organ, point.triangle, point.weights);
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
  return {points.size() == 2 ? "Measure distance" : "Measure angle",
          [points = std::move(points), name = std::move(name)](const DocumentState& state, IdSource& ids) {
            if (points.size() != 2 && points.size() != 3)
              throw UsageError("A distance needs two points and an angle three");
            MeasurementList measurements = *state.measurements;
            Measurement made;
            for (const MeasuredPoint& point : points)
              made.points.push_back(sound(state, point));
            made.name = name.empty() ? freeName(measurements, kindOf(made)) : name;
            made.id = ids.next<MeasurementId>();
            measurements.push_back(std::move(made));
            return withMeasurements(state, std::move(measurements));
          },
          {}};
}

Command moveMeasuredPoint(MeasurementId measurement, std::size_t index, MeasuredPoint point) {
  return {"Move measured point",
          [=](const DocumentState& state, IdSource&) {
            MeasurementList measurements = *state.measurements;
            Measurement& changed = requireMeasurement(measurements, measurement);
            if (index >= changed.points.size())
              throw UsageError("There is no such point", changed.name);
            changed.points[index] = sound(state, point);
            return withMeasurements(state, std::move(measurements));
          },
          "measure/" + std::to_string(measurement.value) + "/" + std::to_string(index)};
}

Command renameMeasurement(MeasurementId measurement, std::string name) {
  return {"Rename measurement",
          [measurement, name = std::move(name)](const DocumentState& state, IdSource&) {
            MeasurementList measurements = *state.measurements;
            requireMeasurement(measurements, measurement).name = name;
            return withMeasurements(state, std::move(measurements));
          },
          {}};
}

Command removeMeasurements(std::vector<MeasurementId> ids) {
  const std::string name = edit::counted("Remove", ids.size(), "measurement");
  return {name,
          [ids = std::move(ids)](const DocumentState& state, IdSource&) {
            MeasurementList measurements = *state.measurements;
            for (const MeasurementId id : ids)
              requireMeasurement(measurements, id);
            std::erase_if(measurements, [&ids](const Measurement& one) {
              return std::find(ids.begin(), ids.end(), one.id) != ids.end();
            });
            return withMeasurements(state, std::move(measurements));
          },
          {}};
}

Command removeAllMeasurements() {
  return {"Remove all measurements",
          [](const DocumentState& state, IdSource&) { return withMeasurements(state, {}); },
          {}};
}

} // namespace viscera::document
