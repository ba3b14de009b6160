#include "viscera/document/validate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "viscera/circulation/scenario.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"

namespace viscera::document {
namespace {

/// How far the sum of weights may be from 1.
constexpr double kWeightSumTolerance = 1e-6;
/// Handles nearer to each other than this part of the rig's diagonal (of 1 mm at least) are at one place.
constexpr double kSamePlace = 1e-9;

void require(bool holds, const Text& problem, const Text& where, const Text& tryThis = {}) {
  if (!holds)
    throw DataError(problem, where, tryThis);
}

void requireName(const std::string& name, const Text& where) {
  require(!name.empty(), "it has no name", where, "give it one");
  require(isUtf8(name), diagnostic("its name is not UTF-8"), where, "give it another one");
}

void requireColor(const Vec3& color, const Text& where) {
  require((color.array() >= 0 && color.array() <= 1).all(),
          diagnostic("the parts of its colour do not lie between 0 and 1"), where);
}

/// Checks places at each movement of a drag, before their names are made.
template <class Place>
bool isPlace(const Place& place) {
  return (place.array().abs() <= kFarthestMm).all(); // Not of what is no number.
}

template <class Place>
void requirePlace(const Place& place, const Text& which, const Text& where) {
  if (!place.allFinite())
    throw DataError(diagnostic("%1 is not a finite number", which), where);
  if (!isPlace(place))
    throw DataError(diagnostic("%1 is farther away than a thousand kilometres", which), where,
                    "check its unit; coordinates are in mm");
}

void requireId(std::int64_t id, const Text& where) {
  require(id > 0 && id <= kLargestId, diagnostic("its id is not a whole number from 1 to 2^52"), where);
}

void validateIds(const DocumentState& state) {
  std::set<std::int64_t> taken;
  const auto take = [&taken](std::int64_t id, const Text& where) {
    requireId(id, where);
    require(taken.insert(id).second, diagnostic("another item has the same id"), where);
  };
  for (const auto& organ : *state.organs)
    take(organ->id.value, phrase("organ %1", named(organ->name)));
  for (const Handle& handle : state.rig->handles)
    take(handle.id.value, phrase("handle %1", named(handle.label)));
  for (const Group& group : state.rig->groups)
    take(group.id.value, phrase("group %1", named(group.name)));
  for (const SequenceKey& key : state.keySequence->keys) {
    take(key.id.value, diagnostic("a keyframe"));
    for (const auto& [handle, moved] : key.displacements)
      requireId(handle.value, diagnostic("a handle of a keyframe"));
  }
  for (const Measurement& measurement : *state.measurements)
    take(measurement.id.value, phrase("measurement %1", named(measurement.name)));
  for (const StressProbe& probe : state.stressMarks->probes)
    take(probe.id.value, phrase("stress probe %1", probe.number));
  for (const StressLine& line : state.stressMarks->lines)
    take(line.id.value, phrase("stress profile %1", state.stressMarks->nameOf(line)));
}

void validateOrgan(const Organ& organ, const DocumentState& known) {
  const Text where = phrase("organ %1", named(organ.name));
  requireName(organ.name, where);
  requireColor(organ.look.color, where);
  require(organ.look.opacity >= 0 && organ.look.opacity <= 1,
          diagnostic("its opacity does not lie between 0 and 1"), where);
  require(!organ.volumeLocked || organ.closed(),
          "its surface is open, so it has no volume that could be locked", where, "close its holes first");
  for (const Text& warning : organ.warnings)
    require(isUtf8(warning.english()), diagnostic("a remark on it is not UTF-8"), where);
  const auto before = known.organ(organ.id);
  if (!before || before->mesh != organ.mesh)
    requirePlace(organ.mesh->points, diagnostic("a point of its surface"), where);
}

void validateOrgans(const DocumentState& state, const DocumentState& known) {
  std::set<OrganId> earlier{OrganId{}};
  for (const auto& organ : *state.organs) {
    if (known.organ(organ->id) != organ)
      validateOrgan(*organ, known);
    require(earlier.count(organ->parent) > 0, diagnostic("the organ that it is a cavity of is not before it"),
            phrase("organ %1", named(organ->name)));
    earlier.insert(organ->id);
  }
}

/// Neighbours along x only: O(n log n) as a rule.
void requireApart(const Rig& rig) {
  const Points rest = rig.restPositions();
  const double apart = kSamePlace * std::max(boundsOf(rest).diagonal(), 1.0);
  std::vector<Eigen::Index> order(static_cast<std::size_t>(rest.rows()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(), [&rest](auto a, auto b) { return rest(a, 0) < rest(b, 0); });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size() && rest(order[j], 0) - rest(order[i], 0) <= apart; ++j)
      if ((rest.row(order[i]) - rest.row(order[j])).norm() <= apart)
        throw DataError("two handles are at one place",
                        phrase("handles %1 and %2",
                               named(rig.handles[static_cast<std::size_t>(order[i])].label),
                               named(rig.handles[static_cast<std::size_t>(order[j])].label)),
                        "move or remove one of them");
}

void validateRig(const Rig& rig) {
  std::map<HandleId, int> rows;
  std::set<std::string> labels, names;
  for (const Handle& handle : rig.handles) {
    const Text where = phrase("handle %1", named(handle.label));
    requireName(handle.label, where);
    require(labels.insert(handle.label).second, "two handles have this label", where, "choose another one");
    require(isUtf8(handle.description), diagnostic("its description is not UTF-8"), where);
    requirePlace(handle.rest, diagnostic("its position at rest"), where);
    rows.emplace(handle.id, static_cast<int>(rows.size()));
  }
  for (const Group& group : rig.groups) {
    const Text where = phrase("group %1", named(group.name));
    requireName(group.name, where);
    require(names.insert(group.name).second, "two groups have this name", where, "choose another one");
    requireColor(group.color, where);
    int last = -1;
    for (const HandleId id : group.handles) {
      const auto row = rows.find(id);
      require(row != rows.end() && row->second > last,
              diagnostic("its handles are not handles of the rig, each once and in their order"), where);
      last = row->second;
    }
  }
  for (const CageTriangle& corners : rig.cage) {
    require(std::all_of(corners.begin(), corners.end(), [&rows](HandleId id) { return rows.count(id) > 0; }),
            diagnostic("a triangle refers to a handle that does not exist"), "cage");
    require(corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0],
            diagnostic("a triangle has a handle at two corners"), "cage");
  }
  requireApart(rig);
}

void validatePose(const DocumentState& state) {
  require(state.pose->rows() == static_cast<Eigen::Index>(state.rig->handles.size()),
          diagnostic("the pose has another number of handles than the document"), "pose");
  if (isPlace(*state.pose))
    return;
  for (std::size_t i = 0; i < state.rig->handles.size(); ++i)
    requirePlace(state.pose->row(static_cast<Eigen::Index>(i)), diagnostic("its position"),
                 phrase("handle %1", named(state.rig->handles[i].label)));
}

void validateSystem(const SystemChoice& system) {
  requireName(system.id, "coordinates");
  for (const auto& [name, value] : system.parameters.all()) {
    require(isUtf8(name), diagnostic("its name is not UTF-8"), "parameter");
    require(std::isfinite(value), diagnostic("its value is not a finite number"),
            diagnostic("parameter %1", name));
  }
}

void validateKeySequence(const KeySequence& keySequence) {
  requireName(keySequence.name, "recording");
  require(keySequence.periodSeconds >= sequences::kShortestSpan && std::isfinite(keySequence.periodSeconds),
          diagnostic("the period is not a positive number of seconds"), named(keySequence.name));
  double earliest = 0;
  for (const SequenceKey& key : keySequence.keys) {
    const Text where = phrase("%1, key at %2 s", named(keySequence.name), inFixed(key.seconds, 6));
    require(&key == keySequence.keys.data() ? key.seconds >= 0
                                            : key.seconds - earliest >= sequences::kShortestSpan,
            "it is not a millisecond at least behind the key before it", where,
            "move it elsewhere, or remove one of the two");
    require(key.seconds < keySequence.periodSeconds, "it does not lie within the period", where,
            "lengthen the period first");
    earliest = key.seconds;
    for (const auto& [handle, moved] : key.displacements)
      requirePlace(moved, diagnostic("a displacement"), where);
  }
  for (const CorrectedContour& correction : keySequence.corrections) {
    const Text where = phrase("%1, correction of phase %2", named(keySequence.name), correction.phase);
    require(correction.phase >= 0 && correction.slice >= 0 && !correction.points.empty(),
            diagnostic("it has no phase, no slice or no points"), where);
    requireName(correction.surface, where);
    for (const Vec3& point : correction.points)
      requirePlace(point, diagnostic("a point"), where);
  }
}

void validateMeasurements(const DocumentState& state) {
  for (const Measurement& measurement : *state.measurements) {
    const Text where = phrase("measurement %1", named(measurement.name));
    requireName(measurement.name, where);
    require(measurement.points.size() == pointCount(measurement.kind),
            diagnostic("an angle has three points, any other measurement two"), where);
    require(measurement.axis >= 0 && measurement.axis < 3, diagnostic("there is no such slice"), where);
    require(measurement.kind != MeasurementKind::gap ||
                (measurement.points[0].organ && measurement.points[1].organ &&
                 measurement.points[0].organ != measurement.points[1].organ),
            diagnostic("a gap is between two organs"), where);
    for (const MeasuredPoint& point : measurement.points) {
      requirePlace(point.rest, diagnostic("one of its points"), where);
      if (!point.organ)
        continue;
      require(!isRegion(measurement.kind), diagnostic("a rectangle or sphere must not refer to an organ"),
              where);
      requireId(point.organ.value, where);
      const auto organ = state.organ(point.organ);
      require(point.triangle >= 0 && (!organ || point.triangle < organ->mesh->triangles.rows()),
              diagnostic("the surface has no such triangle"), where, "pick the point on the surface again");
      require(point.weights.allFinite() && point.weights.minCoeff() >= 0 &&
                  std::abs(point.weights.sum() - 1) <= kWeightSumTolerance,
              diagnostic("barycentric weights must be at least 0 and sum to 1"), where,
              "pick the point on the surface again");
    }
  }
}

void validateStressMarks(const StressMarks& marks) {
  std::set<int> numbers;
  for (const StressProbe& probe : marks.probes) {
    const Text where = phrase("stress probe %1", probe.number);
    require(probe.number > 0, diagnostic("its number is not a whole number from 1"), where);
    require(numbers.insert(probe.number).second, diagnostic("two stress probes have this number"), where);
    requireId(probe.organ.value, where);
    requirePlace(probe.rest, diagnostic("its place at rest"), where);
  }
  for (const StressLine& line : marks.lines) {
    const StressProbe *from = marks.probe(line.from), *to = marks.probe(line.to);
    require(from && to && from != to && from->organ == to->organ,
            diagnostic("it does not join two stress probes of one organ"),
            phrase("stress profile %1", marks.nameOf(line)));
  }
}

void validateCirculation(const CirculationChoice& choice) {
  try {
    circulation::scenario(choice.scenario);
    circulation::checkParameters(choice.parameters);
    if (choice.fitted)
      circulation::checkParameters(*choice.fitted);
    if (choice.kept)
      circulation::checkParameters(choice.kept->parameters);
  } catch (const UsageError& error) {
    throw DataError(error.problem(), error.where(), error.tryThis());
  }
  if (choice.kept)
    requireName(choice.kept->name.english(), diagnostic("circulation that was kept"));
}

} // namespace

void validate(const DocumentState& state, const DocumentState& known) {
  const bool organs = state.organs != known.organs, rig = state.rig != known.rig;
  const bool keySequence = state.keySequence != known.keySequence;
  const bool measurements = state.measurements != known.measurements;
  if (organs)
    validateOrgans(state, known);
  if (rig)
    validateRig(*state.rig);
  if (rig || state.pose != known.pose)
    validatePose(state);
  if (state.system != known.system)
    validateSystem(*state.system);
  if (keySequence)
    validateKeySequence(*state.keySequence);
  if (measurements || organs)
    validateMeasurements(state);
  const bool stressMarks = state.stressMarks != known.stressMarks;
  if (stressMarks)
    validateStressMarks(*state.stressMarks);
  if (state.circulation != known.circulation)
    validateCirculation(*state.circulation);
  if (organs || rig || keySequence || measurements || stressMarks)
    validateIds(state);
}

} // namespace viscera::document
