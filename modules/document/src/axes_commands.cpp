#include "viscera/document/axes_commands.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "viscera/core/arrays.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/document/edit.h"
#include "viscera/medical_io/plausible_size.h"
#include "viscera/medical_io/surface_repairs.h"

namespace viscera::document {
namespace {

/// What is done to all coordinates: a linear map, since repairs of coordinates have no shift.
struct CoordinateChange {
  Eigen::Matrix3d map = Eigen::Matrix3d::Identity();
  Text remark; ///< On every organ.

  bool mirrors() const { return map.determinant() < 0; }
  bool keepsSize() const { return std::abs(map.determinant()) == 1; }
};

Points mapped(const Points& points, const CoordinateChange& change) {
  return points * change.map.transpose();
}

/// A triangle of a mirror image runs the other way round.
template <class Corners>
void turnIfMirrored(Corners& corners, const CoordinateChange& change) {
  if (change.mirrors())
    std::swap(corners[1], corners[2]);
}

/// What was said of the size of an organ is said no more of another size.
void removeRemarksOnSize(std::vector<Text>& warnings, const Organ& organ) {
  const double diagonal = boundsOf(organ.mesh->points).diagonal();
  const double milliliters = std::abs(organ.restVolumeMm3) / kMm3PerMl;
  const auto isSaid = [](const Text& warning, const std::optional<Text>& doubt) {
    return doubt && warning.english() == doubt->english();
  };
  const auto size = medical_io::doubtAboutSize(organ.name, diagonal);
  const auto volume =
      organ.closed() ? medical_io::doubtAboutVolume(organ.name, milliliters) : std::optional<Text>();
  std::erase_if(warnings,
                [&](const Text& warning) { return isSaid(warning, size) || isSaid(warning, volume); });
}

Organ changed(const Organ& organ, const CoordinateChange& change) {
  Organ result = organ;
  geometry::TriangleMesh mesh = *organ.mesh;
  mesh.points = mapped(organ.mesh->points, change);
  if (change.mirrors())
    mesh.triangles.col(1).swap(mesh.triangles.col(2));
  result.mesh = std::make_shared<const geometry::TriangleMesh>(std::move(mesh));
  result.origin = {};
  for (geometry::NamedPlace& place : result.places)
    place.at = change.map * place.at;
  for (geometry::NamedWay& way : result.ways)
    way.points = mapped(way.points, change);
  result.restVolumeMm3 *= std::abs(change.map.determinant());
  if (!change.keepsSize())
    removeRemarksOnSize(result.warnings, organ);
  result.warnings.push_back(change.remark);
  return result;
}

void changeRig(DocumentState& state, const CoordinateChange& change) {
  Rig rig = *state.rig;
  for (Handle& handle : rig.handles)
    handle.rest = change.map * handle.rest;
  for (CageTriangle& triangle : rig.cage)
    turnIfMirrored(triangle, change);
  state.rig = std::make_shared<const Rig>(std::move(rig));
  state.pose = std::make_shared<const Points>(mapped(*state.pose, change));
}

void changeKeys(DocumentState& state, const CoordinateChange& change) {
  KeySequence keys = *state.keySequence;
  for (SequenceKey& key : keys.keys)
    for (auto& [handle, displacement] : key.displacements)
      displacement = change.map * displacement;
  keys.corrections.clear(); // They lie in the planes of a study, which stays where it is.
  state.keySequence = std::make_shared<const KeySequence>(std::move(keys));
}

void changeMarks(DocumentState& state, const CoordinateChange& change) {
  MeasurementList measurements = *state.measurements;
  for (Measurement& measurement : measurements) {
    if (isRegion(measurement.kind))
      continue;
    for (MeasuredPoint& point : measurement.points) {
      point.rest = change.map * point.rest;
      turnIfMirrored(point.weights, change);
    }
  }
  state.measurements = std::make_shared<const MeasurementList>(std::move(measurements));
  StressMarks marks = *state.stressMarks;
  for (StressProbe& probe : marks.probes)
    probe.rest = change.map * probe.rest;
  state.stressMarks = std::make_shared<const StressMarks>(std::move(marks));
}

DocumentState changed(DocumentState state, const CoordinateChange& change) {
  if (state.organs->empty() && state.rig->handles.empty())
    throw UsageError("There are no organs whose coordinates could be converted", {}, "open some first");
  OrganList organs;
  for (const auto& organ : *state.organs)
    organs.push_back(std::make_shared<const Organ>(changed(*organ, change)));
  state.organs = std::make_shared<const OrganList>(std::move(organs));
  changeRig(state, change);
  changeKeys(state, change);
  changeMarks(state, change);
  return state;
}

Command command(Text name, CoordinateChange change) {
  return {std::move(name), [change = std::move(change)](DocumentState state, IdSource&) {
            return changed(std::move(state), change);
          }};
}

/// What a repair makes of the three unit vectors.
Eigen::Matrix3d mapOf(const medical_io::SurfaceRepair& repair) {
  geometry::TriangleMesh axes;
  axes.points = Points::Identity(3, 3);
  axes.triangles.resize(1, 3);
  axes.triangles << 0, 1, 2;
  Progress quiet;
  const Points ends = repair.apply(axes, quiet, Threads{1}).points;
  return ends.transpose();
}

Text nameOf(const std::string& repair) {
  if (repair == "ras-to-lps")
    return "Convert between RAS and LPS";
  if (repair == "mirror")
    return "Mirror left and right";
  return repair.starts_with("unit-") ? Text("Convert the unit") : Text("Convert the axes");
}

} // namespace

std::vector<medical_io::PlacedOrgan> placedOrgans(const OrganList& organs) {
  std::vector<medical_io::PlacedOrgan> placed;
  for (const auto& organ : organs)
    if (organ->origin.sample.empty())
      placed.push_back(
          {organ->name, boundsOf(organ->mesh->points), std::abs(organ->restVolumeMm3) / kMm3PerMl});
  return placed;
}

std::vector<Text> doubtsAboutPatient(const OrganList& organs) {
  std::vector<Text> doubts;
  for (const medical_io::Finding& finding : medical_io::assessPatient(placedOrgans(organs)).findings)
    doubts.push_back(finding.text);
  return doubts;
}

std::vector<std::string> coordinateRepairs() {
  std::vector<std::string> ids;
  for (const medical_io::SurfaceRepair& repair : medical_io::surfaceRepairs()) {
    const bool axes = repair.id == "mirror" || repair.id == "ras-to-lps" || repair.id.starts_with("y-up") ||
                      repair.id.starts_with("flip-");
    if (axes || repair.id.starts_with("unit-"))
      ids.push_back(repair.id);
  }
  return ids;
}

Command convertCoordinates(const std::string& repair) {
  const std::vector<std::string> known = coordinateRepairs();
  if (std::find(known.begin(), known.end(), repair) == known.end())
    throw UsageError(misuse("There is no conversion of coordinates \"%1\"", repair));
  const medical_io::SurfaceRepair& what = medical_io::surfaceRepair(repair);
  return command(nameOf(repair), {mapOf(what), phrase("converted after the import: %1", what.does)});
}

Command scaleCoordinates(double factor) {
  if (!(factor > 0) || !std::isfinite(factor))
    throw UsageError(misuse("A factor of size is a positive number"));
  return command(
      phrase("Scale by %1", inDigits(factor, 4)),
      {factor * Eigen::Matrix3d::Identity(), phrase("scaled after the import by %1", inDigits(factor, 4))});
}

} // namespace viscera::document
