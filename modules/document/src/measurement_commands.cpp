#include "viscera/document/measurement_commands.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

#include "viscera/core/phrase.h"
#include "viscera/document/edit.h"

namespace viscera::document {
namespace {

constexpr const char* kMeasurementKind = "measurement";

/// The point on the organ's surface.
MeasuredPoint sound(const DocumentState& state, const MeasuredPoint& point) {
  if (!point.organ) {
    MeasuredPoint fixed;
    fixed.rest = point.rest;
    return fixed;
  }
  return surfacePoint(*edit::requireOrgan(state, point.organ), point.triangle, point.weights);
}

std::string freeName(const MeasurementList& measurements, MeasurementKind kind) {
  std::string word = nameOf(kind) + ' ';
  word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
  const auto taken = [&](const std::string& name) {
    return std::any_of(measurements.begin(), measurements.end(),
                       [&name](const Measurement& other) { return other.name == name; });
  };
  int number = 1;
  while (taken(word + std::to_string(number)))
    ++number;
  return word + std::to_string(number);
}

/// The organs of a gap are two.
void requireTwoOrgans(const std::vector<MeasuredPoint>& points) {
  if (!points[0].organ || !points[1].organ || points[0].organ == points[1].organ)
    throw UsageError("The shortest distance is between two organs", {}, "select two organs");
}

/// A region lies in the patient, on no organ, and a rectangle in one slice: that of its first point.
void settle(Measurement& measurement) {
  if (!isRegion(measurement.kind))
    return;
  for (MeasuredPoint& point : measurement.points) {
    const Vec3 place = point.rest;
    point = {};
    point.rest = place;
  }
  if (measurement.kind == MeasurementKind::rectangle)
    measurement.points[1].rest[measurement.axis] = measurement.points[0].rest[measurement.axis];
}

} // namespace

Command addMeasurement(std::vector<MeasuredPoint> points, std::string name) {
  const auto kind = points.size() == 2 ? MeasurementKind::distance : MeasurementKind::angle;
  return addMeasurement(Measurement{{}, std::move(name), std::move(points), kind});
}

Command addMeasurement(Measurement wanted) {
  return edit::onPart(
      phrase("Measure %1", nameOf(wanted.kind)), &DocumentState::measurements,
      [wanted = std::move(wanted)](MeasurementList& measurements, const DocumentState& state, IdSource& ids) {
        if (wanted.points.size() != pointCount(wanted.kind))
          throw UsageError(misuse("An angle needs three points, any other measurement two"));
        if (wanted.kind == MeasurementKind::gap)
          requireTwoOrgans(wanted.points);
        if (wanted.axis < 0 || wanted.axis > 2)
          throw UsageError(misuse("A rectangle lies in an axial, coronal or sagittal slice"));
        Measurement made = wanted;
        if (made.kind != MeasurementKind::rectangle)
          made.axis = Measurement().axis;
        settle(made);
        for (MeasuredPoint& point : made.points)
          point = sound(state, point);
        if (made.name.empty())
          made.name = freeName(measurements, made.kind);
        made.id = ids.next<MeasurementId>();
        measurements.push_back(std::move(made));
      });
}

Command addGap(OrganId from, OrganId to) {
  return {"Measure the distance of organs", [from, to](const DocumentState& state, IdSource& ids) {
            Measurement gap;
            gap.kind = MeasurementKind::gap;
            for (const OrganId id : {from, to})
              gap.points.push_back(surfacePoint(*edit::requireOrgan(state, id), 0, Vec3::UnitX()));
            gap.name = state.organ(from)->name + " - " + state.organ(to)->name;
            requireTwoOrgans(gap.points);
            return addMeasurement(std::move(gap)).apply(state, ids);
          }};
}

Command moveMeasuredPoint(MeasurementId measurement, std::size_t index, MeasuredPoint point) {
  return edit::onPart(
      "Move measured point", &DocumentState::measurements,
      [=](MeasurementList& measurements, const DocumentState& state, IdSource&) {
        Measurement& changed = edit::require(measurements, measurement, kMeasurementKind);
        if (index >= changed.points.size())
          throw UsageError(misuse("There is no such point"), changed.name);
        if (changed.kind == MeasurementKind::gap)
          throw UsageError(misuse("The points of a gap are found, not chosen"), changed.name);
        const Vec3 by = point.rest - changed.points[index].rest;
        changed.points[index] = isRegion(changed.kind) ? point : sound(state, point);
        if (changed.kind == MeasurementKind::sphere && index == 0)
          changed.points[1].rest += by;
        if (changed.kind == MeasurementKind::rectangle)
          changed.points[1 - index].rest[changed.axis] = point.rest[changed.axis];
        settle(changed);
      },
      "measure/" + std::to_string(measurement.value) + "/" + std::to_string(index));
}

Command renameMeasurement(MeasurementId measurement, std::string name) {
  return edit::onPart("Rename measurement", &DocumentState::measurements,
                      [measurement, name = std::move(name)](MeasurementList& measurements) {
                        edit::require(measurements, measurement, kMeasurementKind).name = name;
                      });
}

Command removeMeasurements(std::vector<MeasurementId> ids) {
  const Text name = phrase("Remove {measurement|%n measurements}", ids.size());
  return edit::onPart(name, &DocumentState::measurements,
                      [ids = std::move(ids)](MeasurementList& measurements) {
                        edit::remove(measurements, ids, kMeasurementKind);
                      });
}

Command removeAllMeasurements() {
  return edit::onPart("Remove all measurements", &DocumentState::measurements,
                      [](MeasurementList& measurements) { measurements.clear(); });
}

} // namespace viscera::document
