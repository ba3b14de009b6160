#include "viscera/document/organ_commands.h"

#include <algorithm>
#include <set>
#include <utility>

#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/document/edit.h"
#include "viscera/geometry/close_holes.h"
#include "viscera/geometry/surface_check.h"

namespace viscera::document {
namespace {

bool hasName(const OrganList& organs, const std::string& name) {
  return std::any_of(organs.begin(), organs.end(),
                     [&name](const auto& organ) { return organ->name == name; });
}

Command onOrgan(Text name, OrganId id, std::function<void(Organ&)> change, std::string mergeKey = {}) {
  return edit::onPart(
      std::move(name), &DocumentState::organs,
      [id, change = std::move(change)](OrganList& organs, const DocumentState& state, IdSource&) {
        const auto organ = edit::requireOrgan(state, id);
        Organ changed = *organ;
        change(changed);
        std::replace(organs.begin(), organs.end(), organ, std::make_shared<const Organ>(std::move(changed)));
      },
      std::move(mergeKey));
}

DocumentState added(DocumentState state, IdSource& ids, const std::vector<NewOrgan>& newOrgans) {
  OrganList organs = *state.organs;
  const auto present = organs.size();
  for (const NewOrgan& item : newOrgans) {
    if (!item.organ.mesh)
      throw UsageError(misuse("An organ needs a surface"), named(item.organ.name));
    Organ organ = item.organ;
    organ.id = ids.next<OrganId>();
    for (Text& warning : organ.warnings)
      if (const std::string english = warning.english(); !isUtf8(english))
        warning = toUtf8(english);
    organ.name = edit::freeName(organ.name.empty() ? "Organ" : toUtf8(organ.name),
                                [&organs](const std::string& name) { return hasName(organs, name); });
    if (item.parentInBatch >= 0) {
      const std::size_t parent = present + static_cast<std::size_t>(item.parentInBatch);
      if (parent >= organs.size())
        throw UsageError(misuse("A cavity must follow the organ that contains it"), named(organ.name));
      organ.parent = organs[parent]->id;
    } else if (organ.parent && !state.organ(organ.parent)) {
      throw UsageError("The organ that this cavity is in is not there any more", named(organ.name));
    }
    organs.push_back(std::make_shared<const Organ>(std::move(organ)));
  }
  state.organs = std::make_shared<const OrganList>(std::move(organs));
  return state;
}

/// A measurement goes with the organs that its points are on.
DocumentState withoutMeasurementsOf(DocumentState state, const std::set<OrganId>& gone) {
  MeasurementList measurements = *state.measurements;
  const auto removed = std::erase_if(measurements, [&gone](const Measurement& measurement) {
    return std::any_of(measurement.points.begin(), measurement.points.end(),
                       [&gone](const MeasuredPoint& point) { return gone.count(point.organ) > 0; });
  });
  if (removed > 0)
    state.measurements = std::make_shared<const MeasurementList>(std::move(measurements));
  return state;
}

/// A stress probe goes with the organ whose tissue it is pinned to, and a line with its probes.
DocumentState withoutStressMarksOf(DocumentState state, const std::set<OrganId>& gone) {
  StressMarks marks = *state.stressMarks;
  const auto removed =
      std::erase_if(marks.probes, [&gone](const StressProbe& probe) { return gone.count(probe.organ) > 0; });
  if (removed == 0)
    return state;
  std::erase_if(marks.lines, [&marks](const StressLine& line) {
    return !marks.probe(line.from) || !marks.probe(line.to);
  });
  state.stressMarks = std::make_shared<const StressMarks>(std::move(marks));
  return state;
}

DocumentState withoutMarksOf(DocumentState state, const std::set<OrganId>& gone) {
  return withoutStressMarksOf(withoutMeasurementsOf(std::move(state), gone), gone);
}

/// Puts the measured points of an organ onto the surface that it has now.
DocumentState withPointsOnSurfaceOf(DocumentState state, OrganId id) {
  const Organ& organ = *state.organ(id);
  MeasurementList measurements = *state.measurements;
  for (Measurement& measurement : measurements)
    for (MeasuredPoint& point : measurement.points)
      if (point.organ == id)
        point = nearestPoint(organ, point.rest);
  if (measurements != *state.measurements)
    state.measurements = std::make_shared<const MeasurementList>(std::move(measurements));
  return state;
}

DocumentState removed(DocumentState state, const std::vector<OrganId>& ids) {
  for (const OrganId id : ids)
    edit::requireOrgan(state, id);
  std::set<OrganId> gone(ids.begin(), ids.end());
  OrganList organs;
  // A cavity comes after the organ that it is in, so one pass finds cavities of cavities too.
  for (const auto& organ : *state.organs) {
    if (gone.count(organ->id) || gone.count(organ->parent))
      gone.insert(organ->id);
    else
      organs.push_back(organ);
  }
  state.organs = std::make_shared<const OrganList>(std::move(organs));
  return withoutMarksOf(std::move(state), gone);
}

/// The organ with the surface that its holes leave when they are filled.
Organ withoutHoles(const Organ& open) {
  const geometry::ClosedSurface filled = geometry::closeHoles(*open.mesh);
  Organ closed = makeOrgan(open.name, filled.mesh);
  closed.id = open.id;
  closed.look = open.look;
  closed.parent = open.parent;
  closed.mobility = open.mobility;
  closed.file = open.file;
  // Warnings about the file stay; those about the surface are replaced by the findings on the new one.
  const std::vector<std::string> outdated = // From a session, warnings are verbatim.
      inEnglish(geometry::faults(geometry::checkSurface(*open.mesh)));
  std::vector<Text> warnings = open.warnings;
  std::erase_if(warnings, [&outdated](const Text& warning) {
    return std::find(outdated.begin(), outdated.end(), warning.english()) != outdated.end();
  });
  warnings.push_back(phrase("its surface was closed by %n {cap|caps}", filled.holes));
  warnings.insert(warnings.end(), closed.warnings.begin(), closed.warnings.end());
  closed.warnings = std::move(warnings);
  return closed;
}

} // namespace

Command addOrgans(std::vector<NewOrgan> organs) {
  const Text name = organs.size() == 1 ? phrase("Add %1", named(organs.front().organ.name))
                                       : phrase("Add %n {organ|organs}", organs.size());
  return {name, [organs = std::move(organs)](const DocumentState& state, IdSource& ids) {
            return added(state, ids, organs);
          }};
}

Command removeOrgans(std::vector<OrganId> organs) {
  const Text name = phrase("Remove {organ|%n organs}", organs.size());
  return {name, [organs = std::move(organs)](const DocumentState& state, IdSource&) {
            return removed(state, organs);
          }};
}

Command removeAllOrgans() {
  return {"Remove all organs", [](DocumentState state, IdSource&) {
            std::set<OrganId> gone;
            for (const auto& organ : *state.organs)
              gone.insert(organ->id);
            state.organs = std::make_shared<const OrganList>();
            return withoutMarksOf(std::move(state), gone);
          }};
}

Command setOrganLook(OrganId organ, OrganLook look) {
  return onOrgan(
      "Change look", organ, [look](Organ& changed) { changed.look = look; },
      "look/" + std::to_string(organ.value));
}

Command setVolumeLocked(OrganId organ, bool locked) {
  return onOrgan(locked ? "Lock volume" : "Unlock volume", organ, [locked](Organ& changed) {
    if (locked && !changed.closed())
      throw DataError(
          phrase("the surface is open (%n boundary {edge|edges}), so it has no volume that could be locked",
                 changed.boundaryEdges),
          named(changed.name), "close its holes first");
    changed.volumeLocked = locked;
  });
}

Command setMobility(std::vector<OrganId> organs, Mobility mobility) {
  const Text name = mobility == Mobility::rigid   ? "Move as a rigid body"
                    : mobility == Mobility::fixed ? "Keep in place"
                                                  : "Bend as soft tissue";
  std::vector<Command> commands;
  for (const OrganId organ : organs)
    commands.push_back(onOrgan(name, organ, [mobility](Organ& changed) { changed.mobility = mobility; }));
  return combined(name, std::move(commands));
}

Command closeHoles(OrganId organ) {
  return {"Close holes", [organ](const DocumentState& state, IdSource& ids) {
            if (edit::requireOrgan(state, organ)->closed())
              return state;
            const Command fill = onOrgan({}, organ, [](Organ& changed) { changed = withoutHoles(changed); });
            return withPointsOnSurfaceOf(fill.apply(state, ids), organ);
          }};
}

Command renameOrgan(OrganId organ, std::string name) {
  return onOrgan("Rename organ", organ, [name = std::move(name)](Organ& changed) { changed.name = name; });
}

} // namespace viscera::document
