#include "session_json.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/document/validate.h"
#include "viscera/medical_io/slice_frame.h"

namespace viscera::document {
namespace {

using nlohmann::ordered_json;

constexpr JsonReader::Format kFormat = {
    kSessionFormat, kSessionVersion, "session", "choose a file that Viscera has saved as .viscera",
    "take a backup of the file, or begin a new session with the organs' own files"};

bool sameNumbers(const Vec3& a, const Vec3& b) {
  return std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0;
}

ordered_json cageJson(const std::vector<CageTriangle>& cage) {
  ordered_json triangles = ordered_json::array();
  for (const CageTriangle& triangle : cage)
    triangles.push_back({triangle[0].value, triangle[1].value, triangle[2].value});
  return triangles;
}

} // namespace

ordered_json organJson(const Organ& organ) {
  ordered_json item{{"id", organ.id.value}, {"name", organ.name}};
  if (organ.parent)
    item["parent"] = organ.parent.value;
  item["look"] = {{"color", jsonOf(organ.look.color)},
                  {"vertexColors", organ.look.vertexColors},
                  {"opacity", organ.look.opacity},
                  {"visible", organ.look.visible},
                  {"tracked", organ.look.tracked}};
  item["volumeLocked"] = organ.volumeLocked;
  if (organ.mobility != Mobility::bends) // Older versions read the others.
    item["mobility"] = nameOf(organ.mobility);
  return item;
}

ordered_json rigJson(const Rig& rig, const Points& pose) {
  ordered_json handles = ordered_json::array();
  for (std::size_t i = 0; i < rig.handles.size(); ++i) {
    const Handle& handle = rig.handles[i];
    const Vec3 posed = pose.row(static_cast<Eigen::Index>(i)).transpose();
    ordered_json item{{"id", handle.id.value}, {"label", handle.label}, {"rest", jsonOf(handle.rest)}};
    if (!sameNumbers(posed, handle.rest))
      item["pose"] = jsonOf(posed);
    item["locked"] = handle.locked;
    item["visible"] = handle.visible;
    item["compensates"] = handle.compensates;
    if (!handle.description.empty())
      item["description"] = handle.description;
    handles.push_back(std::move(item));
  }
  ordered_json groups = ordered_json::array();
  for (const Group& group : rig.groups) {
    ordered_json members = ordered_json::array();
    for (const HandleId id : group.handles)
      members.push_back(id.value);
    groups.push_back({{"id", group.id.value},
                      {"name", group.name},
                      {"color", jsonOf(group.color)},
                      {"handles", std::move(members)}});
  }
  ordered_json item{{"handles", std::move(handles)}, {"groups", std::move(groups)}};
  if (!rig.cage.empty())
    item["cage"] = cageJson(rig.cage);
  return item;
}

ordered_json systemJson(const SystemChoice& system) {
  ordered_json parameters = ordered_json::object();
  for (const auto& [name, value] : system.parameters.all())
    parameters[name] = value;
  return {{"id", system.id}, {"parameters", std::move(parameters)}};
}

ordered_json keySequenceJson(const KeySequence& keySequence) {
  ordered_json keys = ordered_json::array();
  for (const SequenceKey& key : keySequence.keys) {
    ordered_json displacements = ordered_json::array();
    for (const auto& [handle, moved] : key.displacements)
      displacements.push_back({{"handle", handle.value}, {"by", jsonOf(moved)}});
    keys.push_back({{"id", key.id.value},
                    {"seconds", key.seconds},
                    {"easing", nameOf(key.easing)},
                    {"displacements", std::move(displacements)}});
  }
  ordered_json item{{"name", keySequence.name},
                    {"periodSeconds", keySequence.periodSeconds},
                    {"loop", keySequence.loop},
                    {"interpolation", nameOf(keySequence.interpolation)},
                    {"keys", std::move(keys)}};
  for (const CorrectedContour& correction : keySequence.corrections) {
    ordered_json points = ordered_json::array();
    for (const Vec3& point : correction.points)
      points.push_back(jsonOf(point));
    item["corrections"].push_back({{"phase", correction.phase},
                                   {"slice", correction.slice},
                                   {"surface", correction.surface},
                                   {"pointsMm", std::move(points)}});
  }
  return item;
}

namespace {

std::string sliceOf(int axis) {
  for (const medical_io::SliceDirection& direction : medical_io::sliceDirections())
    if (direction.axis == axis)
      return direction.id;
  return {};
}

} // namespace

ordered_json measurementsJson(const MeasurementList& measurements,
                              const std::function<bool(OrganId)>& isKnown) {
  ordered_json list = ordered_json::array();
  for (const Measurement& measurement : measurements) {
    ordered_json points = ordered_json::array();
    for (const MeasuredPoint& point : measurement.points) {
      ordered_json item{{"rest", jsonOf(point.rest)}};
      if (point.organ && isKnown(point.organ)) {
        item["organ"] = point.organ.value;
        item["triangle"] = point.triangle;
        item["weights"] = jsonOf(point.weights);
      }
      points.push_back(std::move(item));
    }
    ordered_json item{{"id", measurement.id.value}, {"name", measurement.name}};
    if (isRegion(measurement.kind))
      item["kind"] = nameOf(measurement.kind);
    if (measurement.kind == MeasurementKind::rectangle)
      item["slice"] = sliceOf(measurement.axis);
    item["points"] = std::move(points);
    list.push_back(std::move(item));
  }
  return list;
}

ordered_json stressMarksJson(const StressMarks& marks, const std::function<bool(OrganId)>& isKnown) {
  ordered_json probes = ordered_json::array(), lines = ordered_json::array();
  const auto kept = [&](StressProbeId id) {
    const StressProbe* probe = marks.probe(id);
    return probe && isKnown(probe->organ);
  };
  for (const StressProbe& probe : marks.probes)
    if (kept(probe.id))
      probes.push_back({{"id", probe.id.value},
                        {"number", probe.number},
                        {"organ", probe.organ.value},
                        {"rest", jsonOf(probe.rest)}});
  for (const StressLine& line : marks.lines)
    if (kept(line.from) && kept(line.to))
      lines.push_back({{"id", line.id.value}, {"from", line.from.value}, {"to", line.to.value}});
  return {{"probes", std::move(probes)}, {"lines", std::move(lines)}};
}

namespace {

/// Always written: without it a session is of a time when atria were smaller.
constexpr auto kAtriumSaid = "laV0";

/// Ml by which the atria's unstressed volumes were smaller in sessions that do not state them; the
/// blood in the loop and the pericardium's room were smaller by as much, so that their pressures are those of
/// today.
constexpr double kSmallerLeftAtriumMl = 15, kSmallerRightAtriumMl = 25;

void addToAtria(circulation::Parameters& parameters, double leftMl, double rightMl) {
  parameters.la.v0 += leftMl;
  parameters.ra.v0 += rightMl;
  parameters.stressedVolume += leftMl + rightMl;
  parameters.pericardialRoom += leftMl + rightMl;
}

double mostOf(const std::string& parameter) {
  for (const circulation::ParameterInfo& info : circulation::parameterInfos())
    if (info.name == parameter)
      return info.highest;
  return std::numeric_limits<double>::infinity();
}

ordered_json parametersJson(const circulation::Parameters& parameters) {
  ordered_json changed = ordered_json::object();
  for (const circulation::ParameterInfo& info : circulation::parameterInfos())
    if (const double value = circulation::parameter(parameters, info.name);
        value != info.rest || info.name == kAtriumSaid)
      changed[info.name] = value;
  return changed;
}

} // namespace

ordered_json circulationJson(const CirculationChoice& choice) {
  ordered_json item{{"drives", choice.drives},
                    {"scenario", choice.scenario},
                    {"parameters", parametersJson(choice.parameters)}};
  if (choice.fitted)
    item["fitted"] = parametersJson(*choice.fitted);
  if (choice.kept)
    item["kept"] = {{"name", choice.kept->name}, {"parameters", parametersJson(choice.kept->parameters)}};
  return item;
}

SessionReader::SessionReader(const std::string& where) : JsonReader(where, kFormat) {}

std::string SessionReader::optionalText(const ordered_json& object, const char* key,
                                        const std::string& place) const {
  const auto found = object.find(key);
  if (found == object.end())
    return {};
  if (!found->is_string())
    fail(diagnostic("\"%1\" is not a text", key), place);
  return found->get<std::string>();
}

void SessionReader::requireValid(const DocumentState& state, const DocumentState& known) const {
  try {
    validate(state, known);
  } catch (const DataError& error) {
    fail(error.problem(), error.where().english());
  }
}

template <class AnyId>
AnyId SessionReader::newId(const ordered_json& object, const std::string& place) {
  const AnyId id{wholeOf(field(object, "id", place), place + ".id")};
  if (!id || id.value > kLargestId)
    fail(diagnostic("its id is not a whole number from 1 to 2^52"), place);
  if (!ids_.insert(id.value).second)
    fail(diagnostic("the id %1 comes twice", id.value), place);
  return id;
}

Organ SessionReader::readOrganRecord(const ordered_json& item, const std::string& place) {
  takeObject(item,
             {"id", "name", "parent", "look", "volumeLocked", "mobility", "source", "sha256", "surface",
              "warnings", "remarks"},
             place);
  Organ organ;
  organ.id = newId<OrganId>(item, place);
  organ.name = textOf(item, "name", place);
  if (item.contains("parent"))
    organ.parent = OrganId{wholeOf(item.at("parent"), place + ".parent")};
  const ordered_json& look = field(item, "look", place);
  const std::string inLook = place + ".look";
  takeObject(look, {"color", "vertexColors", "opacity", "visible", "tracked"}, inLook);
  organ.look.color = colorOf(field(look, "color", inLook), inLook + ".color");
  organ.look.vertexColors = flagOf(look, "vertexColors", inLook);
  organ.look.opacity = numberOf(field(look, "opacity", inLook), inLook + ".opacity");
  if (!(organ.look.opacity >= 0 && organ.look.opacity <= 1)) // Also of an organ whose file is missing.
    fail(diagnostic("does not lie between 0 and 1"), inLook + ".opacity");
  organ.look.visible = flagOf(look, "visible", inLook);
  organ.look.tracked = flagOf(look, "tracked", inLook);
  organ.volumeLocked = flagOf(item, "volumeLocked", place);
  if (item.contains("mobility")) {
    const auto mobility = mobilityFromName(textOf(item, "mobility", place));
    if (!mobility)
      fail(diagnostic("is none of bends, rigid, fixed"), place + ".mobility");
    organ.mobility = *mobility;
  }
  return organ;
}

Handle SessionReader::readHandle(const ordered_json& item, const std::string& place) {
  takeObject(item, {"id", "label", "rest", "pose", "locked", "visible", "compensates", "description"}, place);
  Handle handle;
  handle.id = newId<HandleId>(item, place);
  handle.label = textOf(item, "label", place);
  handle.rest = vectorOf(field(item, "rest", place), place + ".rest");
  handle.locked = flagOf(item, "locked", place);
  handle.visible = flagOf(item, "visible", place);
  handle.compensates = flagOf(item, "compensates", place);
  handle.description = optionalText(item, "description", place);
  return handle;
}

Group SessionReader::readGroup(const ordered_json& item, const std::string& place) {
  takeObject(item, {"id", "name", "color", "handles"}, place);
  Group group;
  group.id = newId<GroupId>(item, place);
  group.name = textOf(item, "name", place);
  group.color = colorOf(field(item, "color", place), place + ".color");
  for (const ordered_json& member : listOf(item, "handles", place))
    group.handles.push_back({wholeOf(member, place + ".handles")});
  return group;
}

void SessionReader::readCage(const ordered_json& list, Rig& rig) const {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string place = at("rig.cage", i);
    if (!list[i].is_array() || list[i].size() != 3)
      fail(diagnostic("It is not a triangle of three handles"), place);
    CageTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k)
      triangle[k] = HandleId{wholeOf(list[i][k], place)};
    rig.cage.push_back(triangle);
  }
}

void SessionReader::readRig(const ordered_json& item, DocumentState& state) {
  takeObject(item, {"handles", "groups", "cage"}, "rig");
  Rig rig;
  const ordered_json& handles = listOf(item, "handles", "rig");
  Points pose(static_cast<Eigen::Index>(handles.size()), 3);
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const std::string place = at("rig.handles", i);
    rig.handles.push_back(readHandle(handles[i], place));
    const Handle& handle = rig.handles.back();
    pose.row(static_cast<Eigen::Index>(i)) =
        (handles[i].contains("pose") ? vectorOf(handles[i].at("pose"), place + ".pose") : handle.rest)
            .transpose();
  }
  const ordered_json& groups = listOf(item, "groups", "rig");
  for (std::size_t i = 0; i < groups.size(); ++i)
    rig.groups.push_back(readGroup(groups[i], at("rig.groups", i)));
  if (item.contains("cage"))
    readCage(listOf(item, "cage", "rig"), rig);
  state.rig = std::make_shared<const Rig>(std::move(rig));
  state.pose = std::make_shared<const Points>(std::move(pose));
}

void SessionReader::readSystem(const ordered_json& item, DocumentState& state) {
  takeObject(item, {"id", "parameters"}, "system");
  SystemChoice choice;
  choice.id = textOf(item, "id", "system");
  const ordered_json& parameters = field(item, "parameters", "system");
  requireObject(parameters, "system.parameters");
  for (const auto& [name, value] : parameters.items())
    choice.parameters.set(name, numberOf(value, "system.parameters." + name));
  state.system = std::make_shared<const SystemChoice>(std::move(choice));
}

SequenceKey SessionReader::readKey(const ordered_json& item, const std::string& place) {
  takeObject(item, {"id", "seconds", "easing", "displacements"}, place);
  SequenceKey key;
  key.id = newId<KeyId>(item, place);
  key.seconds = numberOf(field(item, "seconds", place), place + ".seconds");
  key.easing = named(sequences::easingFromName, item, "easing", place, "linear, smooth, in, out, hold");
  const ordered_json& list = listOf(item, "displacements", place);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string inList = at(place + ".displacements", i);
    takeObject(list[i], {"handle", "by"}, inList);
    const HandleId handle{wholeOf(field(list[i], "handle", inList), inList + ".handle")};
    if (!key.displacements.emplace(handle, vectorOf(field(list[i], "by", inList), inList + ".by")).second)
      fail(diagnostic("the handle %1 comes twice", handle.value), inList);
  }
  return key;
}

void SessionReader::readKeySequence(const ordered_json& item, DocumentState& state) {
  takeObject(item, {"name", "periodSeconds", "loop", "interpolation", "keys", "corrections"}, "recording");
  KeySequence keySequence;
  if (const std::string name = optionalText(item, "name", "recording"); !name.empty())
    keySequence.name = name;
  keySequence.periodSeconds = numberOf(field(item, "periodSeconds", "recording"), "recording.periodSeconds");
  keySequence.loop = flagOf(item, "loop", "recording");
  keySequence.interpolation =
      named(sequences::interpolationFromName, item, "interpolation", "recording", "eased, curve");
  const ordered_json& keys = listOf(item, "keys", "recording");
  for (std::size_t i = 0; i < keys.size(); ++i)
    keySequence.keys.push_back(readKey(keys[i], at("recording.keys", i)));
  eachOf(item, "corrections", "recording", [&](const ordered_json& correction, const std::string& place) {
    takeObject(correction, {"phase", "slice", "surface", "pointsMm"}, place);
    keySequence.corrections.push_back({wholeOf(field(correction, "phase", place), place + ".phase"),
                                       wholeOf(field(correction, "slice", place), place + ".slice"),
                                       textOf(correction, "surface", place),
                                       valueOf<std::vector<Vec3>>(correction, "pointsMm", place)});
  });
  state.keySequence = std::make_shared<const KeySequence>(std::move(keySequence));
}

MeasuredPoint SessionReader::readMeasuredPoint(const ordered_json& item, const std::string& place) {
  takeObject(item, {"rest", "organ", "triangle", "weights"}, place);
  MeasuredPoint point;
  point.rest = vectorOf(field(item, "rest", place), place + ".rest");
  if (!item.contains("organ"))
    return point;
  point.organ = OrganId{wholeOf(item.at("organ"), place + ".organ")};
  const std::int64_t triangle = wholeOf(field(item, "triangle", place), place + ".triangle");
  if (triangle > std::numeric_limits<int>::max())
    fail(diagnostic("no surface has so many triangles"), place + ".triangle");
  point.triangle = static_cast<int>(triangle);
  point.weights = vectorOf(field(item, "weights", place), place + ".weights");
  return point;
}

/// Reads the kind of a measurement, which two points do not determine; distances and angles differ by their
/// number of points.
void SessionReader::readMeasurementKind(const ordered_json& item, const std::string& place,
                                        Measurement& measurement) const {
  if (item.contains("kind"))
    measurement.kind =
        named(measurementKindFromName, item, "kind", place, "distance, angle, rectangle, sphere, gap");
  if (measurement.kind != MeasurementKind::rectangle)
    return;
  try {
    measurement.axis = medical_io::sliceDirection(textOf(item, "slice", place)).axis;
  } catch (const UsageError& error) {
    fail(error.problem(), place + ".slice");
  }
}

void SessionReader::readMeasurements(const ordered_json& root, DocumentState& state) {
  if (!root.contains("measurements"))
    return;
  MeasurementList measurements;
  const ordered_json& list = listOf(root, "measurements", "");
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string place = at("measurements", i);
    takeObject(list[i], {"id", "name", "kind", "slice", "points"}, place);
    Measurement measurement;
    measurement.id = newId<MeasurementId>(list[i], place);
    measurement.name = textOf(list[i], "name", place);
    readMeasurementKind(list[i], place, measurement);
    const ordered_json& points = listOf(list[i], "points", place);
    for (std::size_t k = 0; k < points.size(); ++k)
      measurement.points.push_back(readMeasuredPoint(points[k], at(place + ".points", k)));
    if (!list[i].contains("kind") && points.size() == pointCount(MeasurementKind::angle))
      measurement.kind = MeasurementKind::angle;
    measurements.push_back(std::move(measurement));
  }
  state.measurements = std::make_shared<const MeasurementList>(std::move(measurements));
}

void SessionReader::readStressMarks(const ordered_json& root, DocumentState& state) {
  if (!root.contains("stressMarks"))
    return;
  const ordered_json& item = root.at("stressMarks");
  takeObject(item, {"probes", "lines"}, "stressMarks");
  StressMarks marks;
  const ordered_json& probes = listOf(item, "probes", "stressMarks");
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const std::string place = at("stressMarks.probes", i);
    takeObject(probes[i], {"id", "number", "organ", "rest"}, place);
    StressProbe probe;
    probe.id = newId<StressProbeId>(probes[i], place);
    const std::int64_t number = wholeOf(field(probes[i], "number", place), place + ".number");
    if (number < 1 || number > std::numeric_limits<int>::max())
      fail(diagnostic("its number is not a whole number from 1"), place + ".number");
    probe.number = static_cast<int>(number);
    probe.organ = OrganId{wholeOf(field(probes[i], "organ", place), place + ".organ")};
    probe.rest = vectorOf(field(probes[i], "rest", place), place + ".rest");
    marks.probes.push_back(probe);
  }
  const ordered_json& lines = listOf(item, "lines", "stressMarks");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string place = at("stressMarks.lines", i);
    takeObject(lines[i], {"id", "from", "to"}, place);
    StressLine line;
    line.id = newId<StressLineId>(lines[i], place);
    line.from = StressProbeId{wholeOf(field(lines[i], "from", place), place + ".from")};
    line.to = StressProbeId{wholeOf(field(lines[i], "to", place), place + ".to")};
    marks.lines.push_back(line);
  }
  state.stressMarks = std::make_shared<const StressMarks>(std::move(marks));
}

circulation::Parameters SessionReader::readParameters(const ordered_json& item,
                                                      const std::string& place) const {
  requireObject(item, place);
  circulation::Parameters parameters;
  const bool older = !item.contains(kAtriumSaid);
  if (older)
    addToAtria(parameters, -kSmallerLeftAtriumMl, -kSmallerRightAtriumMl);
  for (const auto& [name, value] : item.items()) {
    try {
      circulation::setParameter(parameters, name, numberOf(value, place + "." + name));
    } catch (const UsageError& error) {
      fail(error.problem(), place + "." + name);
    }
  }
  if (older) {
    addToAtria(parameters, kSmallerLeftAtriumMl, kSmallerRightAtriumMl);
    // The most that a control allows is no more than before.
    for (const char* name : {"raV0", "stressedVolume", "pericardialRoom"})
      circulation::setParameter(parameters, name,
                                std::min(circulation::parameter(parameters, name), mostOf(name)));
  }
  return parameters;
}

void SessionReader::readCirculation(const ordered_json& root, DocumentState& state) {
  if (!root.contains("circulation"))
    return;
  const ordered_json& item = root.at("circulation");
  takeObject(item, {"drives", "scenario", "parameters", "fitted", "kept"}, "circulation");
  CirculationChoice choice;
  choice.drives = flagOf(item, "drives", "circulation");
  choice.scenario = textOf(item, "scenario", "circulation");
  choice.parameters = readParameters(field(item, "parameters", "circulation"), "circulation.parameters");
  if (item.contains("fitted"))
    choice.fitted = readParameters(item.at("fitted"), "circulation.fitted");
  if (item.contains("kept")) {
    const ordered_json& kept = item.at("kept");
    takeObject(kept, {"name", "parameters"}, "circulation.kept");
    choice.kept = {
        viscera::named(textOf(kept, "name", "circulation.kept")),
        readParameters(field(kept, "parameters", "circulation.kept"), "circulation.kept.parameters")};
  }
  state.circulation = std::make_shared<const CirculationChoice>(std::move(choice));
}

} // namespace viscera::document
