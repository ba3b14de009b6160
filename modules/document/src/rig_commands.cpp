#include "viscera/document/rig_commands.h"

#include <charconv>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/document/edit.h"

namespace viscera::document {
namespace {

/// How far a box around vertices in no region reaches beyond them, as a part of their organ's diagonal.
constexpr double kEnclosingMargin = 0.03;

/// Handles of a sequence may be apart from the rig's by this part of the size of all.
constexpr double kSameRest = 1e-6;

/// Larger numbers of labels are not counted on from: there would be none left.
constexpr int kLargestNumber = 1'000'000'000;

/// The number of a label "H-n", or 0.
int numberOf(const std::string& label) {
  int number = 0;
  if (label.rfind("H-", 0) == 0)
    std::from_chars(label.data() + 2, label.data() + label.size(), number);
  return number > 0 && number <= kLargestNumber ? number : 0;
}

/// Puts new handles behind those of `rig`, and their positions behind `pose`. Returns their ids.
std::vector<HandleId> append(Rig& rig, Points& pose, const std::vector<NewHandle>& handles, IdSource& ids) {
  std::set<std::string> labels;
  int number = 0;
  for (const Handle& handle : rig.handles) {
    labels.insert(handle.label);
    number = std::max(number, numberOf(handle.label));
  }
  for (const NewHandle& handle : handles)
    number = std::max(number, numberOf(handle.label));
  const Eigen::Index present = pose.rows();
  pose.conservativeResize(present + static_cast<Eigen::Index>(handles.size()), 3);
  std::vector<HandleId> added;
  for (const NewHandle& item : handles) {
    const std::string wanted = item.label.empty() ? "H-" + std::to_string(++number) : toUtf8(item.label);
    const std::string label =
        edit::freeName(wanted, [&](const std::string& name) { return labels.count(name) > 0; });
    labels.insert(label);
    pose.row(present + static_cast<Eigen::Index>(added.size())) = item.posed.value_or(item.rest).transpose();
    added.push_back(ids.next<HandleId>());
    rig.handles.push_back(
        {added.back(), label, item.rest, item.locked, item.visible, toUtf8(item.description)});
  }
  return added;
}

std::string freeGroupName(const Rig& rig, const std::string& wanted) {
  return edit::freeName(wanted.empty() ? "Group" : toUtf8(wanted), [&rig](const std::string& name) {
    return std::any_of(rig.groups.begin(), rig.groups.end(),
                       [&name](const Group& g) { return g.name == name; });
  });
}

/// Puts the corners of a box into a rig as a group of their own.
DocumentState withBox(const DocumentState& state, const Points& corners, const std::string& name,
                      IdSource& ids) {
  std::vector<NewHandle> handles = newHandles(corners);
  for (std::size_t i = 0; i < handles.size(); ++i)
    handles[i].label = "E-" + std::to_string(i + 1);
  Rig rig = *state.rig;
  Points pose = *state.pose;
  const std::vector<HandleId> added = append(rig, pose, handles, ids);
  rig.groups.push_back({ids.next<GroupId>(), freeGroupName(rig, name), {0.6, 0.6, 0.65}, added});
  return edit::withRig(state, std::move(rig), std::move(pose));
}

DocumentState enclosed(const DocumentState& state, IdSource& ids) {
  if (state.organs->empty())
    throw UsageError("There is no organ to enclose", {}, "open one first");
  const Points everything = edit::joined(state.rig->restPositions(), edit::allPoints(*state.organs));
  return withBox(state, deformation::enclosingHandles(everything), "Enclosing", ids);
}

DocumentState withEnclosingGroup(const DocumentState& state, OrganId id, const std::vector<int>& vertices,
                                 IdSource& ids) {
  const auto organ = edit::requireOrgan(state, id);
  const Points& points = organ->mesh->points;
  if (vertices.empty() || *std::min_element(vertices.begin(), vertices.end()) < 0 ||
      *std::max_element(vertices.begin(), vertices.end()) >= points.rows())
    throw UsageError(
        misuse("The list of vertices to enclose is empty or names vertices that the organ does not have"),
        organ->name);
  const Bounds box = boundsOf(points(vertices, Eigen::all));
  const double grow = kEnclosingMargin * boundsOf(points).diagonal();
  Points ends(2, 3);
  ends << (box.low.array() - grow).transpose(), (box.high.array() + grow).transpose();
  return withBox(state, deformation::enclosingHandles(ends, 0), "Enclosing", ids);
}

DocumentState movedAtRest(const DocumentState& state, const std::vector<HandleId>& handles,
                          const Points& positions) {
  edit::requireMatch(positions, handles);
  Rig rig = *state.rig;
  Points pose = *state.pose;
  for (const auto& [row, item] : edit::freeRows(rig, handles)) {
    Vec3& rest = rig.handles[static_cast<std::size_t>(row)].rest;
    const Vec3 moved = positions.row(item).transpose();
    const Vec3 posed = pose.row(row).transpose();
    const bool wasAtRest = posed == rest;
    pose.row(row) = (wasAtRest ? moved : Vec3(moved + (posed - rest))).transpose();
    rest = moved;
  }
  return edit::withRig(state, std::move(rig), std::move(pose));
}

DocumentState withoutHandles(const DocumentState& state, const std::vector<HandleId>& handles) {
  Rig rig;
  Points pose(state.pose->rows(), 3);
  for (const HandleId id : handles)
    edit::requireHandle(*state.rig, id);
  const std::set<HandleId> gone(handles.begin(), handles.end());
  for (std::size_t i = 0; i < state.rig->handles.size(); ++i)
    if (!gone.count(state.rig->handles[i].id)) {
      pose.row(static_cast<Eigen::Index>(rig.handles.size())) = state.pose->row(static_cast<Eigen::Index>(i));
      rig.handles.push_back(state.rig->handles[i]);
    }
  pose.conservativeResize(static_cast<Eigen::Index>(rig.handles.size()), 3);
  rig.groups = state.rig->groups;
  for (Group& group : rig.groups)
    std::erase_if(group.handles, [&gone](HandleId id) { return gone.count(id) > 0; });
  const auto& cage = state.rig->cage;
  const bool open = std::any_of(cage.begin(), cage.end(), [&gone](const CageTriangle& triangle) {
    return std::any_of(triangle.begin(), triangle.end(), [&gone](HandleId id) { return gone.count(id) > 0; });
  });
  if (!open)
    rig.cage = cage;
  return edit::withRig(state, std::move(rig), std::move(pose));
}

DocumentState withNewRig(const DocumentState& state, const Rig& replacement, IdSource& ids) {
  Rig rig;
  Points pose(0, 3);
  std::vector<NewHandle> handles;
  std::map<HandleId, Eigen::Index> rows;
  for (const Handle& handle : replacement.handles) {
    rows.emplace(handle.id, static_cast<Eigen::Index>(handles.size()));
    handles.push_back(
        {handle.rest, std::nullopt, handle.label, handle.description, handle.locked, handle.visible});
  }
  const std::vector<HandleId> added = append(rig, pose, handles, ids);
  for (std::size_t i = 0; i < added.size(); ++i)
    rig.handles[i].compensates = replacement.handles[i].compensates;
  const auto rowOf = [&rows](HandleId id) {
    const auto found = rows.find(id);
    return found == rows.end() ? -1 : found->second;
  };
  for (const Group& item : replacement.groups) {
    Group group{ids.next<GroupId>(), freeGroupName(rig, item.name), item.color, {}};
    std::set<Eigen::Index> members; // In the order of the rig.
    for (const HandleId id : item.handles)
      members.insert(rowOf(id));
    if (members.contains(-1))
      throw UsageError(misuse("A group refers to a handle that does not exist"), item.name);
    for (const Eigen::Index row : members)
      group.handles.push_back(added[static_cast<std::size_t>(row)]);
    rig.groups.push_back(std::move(group));
  }
  Triangles cage(static_cast<Eigen::Index>(replacement.cage.size()), 3);
  for (Eigen::Index t = 0; t < cage.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      cage(t, k) = static_cast<Triangles::Scalar>(
          rowOf(replacement.cage[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)]));
  rig.cage = edit::cageOf(rig, cage);
  return edit::withRig(state, std::move(rig), std::move(pose));
}

Text nameOf(const HandleEdit& change, std::size_t count) {
  if (change.label)
    return "Rename handle";
  if (change.locked)
    return *change.locked ? phrase("Lock {handle|%n handles}", count)
                          : phrase("Unlock {handle|%n handles}", count);
  if (change.compensates)
    return *change.compensates ? phrase("Compensate with {handle|%n handles}", count)
                               : phrase("Stop compensating with {handle|%n handles}", count);
  if (change.visible)
    return *change.visible ? phrase("Show {handle|%n handles}", count)
                           : phrase("Hide {handle|%n handles}", count);
  return phrase("Describe {handle|%n handles}", count);
}

} // namespace

std::vector<NewHandle> newHandles(const Points& positions) {
  std::vector<NewHandle> handles(static_cast<std::size_t>(positions.rows()));
  for (std::size_t i = 0; i < handles.size(); ++i)
    handles[i].rest = positions.row(static_cast<Eigen::Index>(i)).transpose();
  return handles;
}

Command addHandles(std::vector<NewHandle> handles, GroupId group) {
  const Text name = phrase("Add {handle|%n handles}", handles.size());
  return {name, [handles = std::move(handles), group](const DocumentState& state, IdSource& ids) {
            Rig rig = *state.rig;
            Points pose = *state.pose;
            Group* const into = group ? &edit::require(rig.groups, group, "group") : nullptr;
            const std::vector<HandleId> added = append(rig, pose, handles, ids);
            if (into)
              into->handles.insert(into->handles.end(), added.begin(), added.end());
            return edit::withRig(state, std::move(rig), std::move(pose));
          }};
}

Command addEnclosingHandles() {
  return {"Add enclosing handles",
          [](const DocumentState& state, IdSource& ids) { return enclosed(state, ids); }};
}

Command addEnclosingGroup(OrganId organ, std::vector<int> vertices) {
  return {"Add enclosing group",
          [organ, vertices = std::move(vertices)](const DocumentState& state, IdSource& ids) {
            return withEnclosingGroup(state, organ, vertices, ids);
          }};
}

Command removeHandles(std::vector<HandleId> handles) {
  const Text name = phrase("Remove {handle|%n handles}", handles.size());
  return {name, [handles = std::move(handles)](const DocumentState& state, IdSource&) {
            return withoutHandles(state, handles);
          }};
}

Command moveRestHandles(std::vector<HandleId> handles, Points positions) {
  const Text name = phrase("Move {handle|%n handles} at rest", handles.size());
  return {name,
          [handles = std::move(handles), positions = std::move(positions)](
              const DocumentState& state, IdSource&) { return movedAtRest(state, handles, positions); }};
}

Command replaceRig(Rig rig, Text name) {
  return {std::move(name), [rig = std::move(rig)](const DocumentState& state, IdSource& ids) {
            return withNewRig(state, rig, ids);
          }};
}

Rig completed(const Rig& rig) {
  IdSource ids;
  return *replaceRig(rig).apply(DocumentState(), ids).rig;
}

Command editHandles(std::vector<HandleId> handles, HandleEdit change) {
  const Text name = nameOf(change, handles.size());
  return edit::onPart(name, &DocumentState::rig,
                      [handles = std::move(handles), change = std::move(change)](Rig& rig) {
                        for (const HandleId id : handles) {
                          Handle& handle = edit::require(rig.handles, id, "handle");
                          handle.label = change.label.value_or(handle.label);
                          handle.description = change.description.value_or(handle.description);
                          handle.locked = change.locked.value_or(handle.locked);
                          handle.visible = change.visible.value_or(handle.visible);
                          handle.compensates = change.compensates.value_or(handle.compensates);
                        }
                      });
}

Command moveHandles(std::vector<HandleId> handles, Points positions) {
  const Text name = phrase("Move {handle|%n handles}", handles.size());
  return edit::onPart(name, &DocumentState::pose,
                      [handles = std::move(handles), positions = std::move(positions)](
                          Points& pose, const DocumentState& state, IdSource&) {
                        edit::requireMatch(positions, handles);
                        for (const auto& [row, item] : edit::freeRows(*state.rig, handles))
                          pose.row(row) = positions.row(item);
                      });
}

Command setPose(std::shared_ptr<const Points> pose, Text name) {
  return {std::move(name), [pose = std::move(pose)](DocumentState state, IdSource&) {
            if (pose->rows() != state.pose->rows())
              throw DataError(
                  misuse("The pose has %1 handles, the document %2", pose->rows(), state.pose->rows()), {},
                  misuse("use a pose of the same handles"));
            state.pose = pose;
            return state;
          }};
}

Command resetPose() {
  return edit::onPart(
      "Reset pose", &DocumentState::pose,
      [](Points& pose, const DocumentState& state, IdSource&) { pose = state.rig->restPositions(); });
}

void requireFits(const Rig& rig, const sequences::Sequence& sequence) {
  const Points& own = sequence.restHandles();
  const Points rest = rig.restPositions();
  const Text advice = "take the sequence's own handles";
  if (own.rows() != rest.rows())
    throw DataError(phrase("The sequence moves %1 handles, but there are %2", own.rows(), rest.rows()),
                    sequence.name(), advice);
  const double size = std::max(boundsOf(own).diagonal(), 1.0);
  for (Eigen::Index i = 0; i < rest.rows(); ++i)
    if (!((own.row(i) - rest.row(i)).norm() <= kSameRest * size))
      throw DataError(
          "The sequence was made for another place of a handle",
          phrase("%1, handle %2", sequence.name(), named(rig.handles[static_cast<std::size_t>(i)].label)),
          advice);
}

Rig rigOf(const sequences::Sequence& sequence) {
  Rig rig = rigAt(sequence.restHandles());
  for (const sequences::HandleGroup& group : sequence.groups()) {
    rig.addGroup(group.name, group.color, group.handles);
    int number = 0;
    for (const int handle : group.handles)
      rig.handles[static_cast<std::size_t>(handle)].label = group.name + " " + std::to_string(++number);
  }
  if (rig.groups.empty()) {
    std::vector<int> all(rig.handles.size());
    std::iota(all.begin(), all.end(), 0);
    rig.addGroup(sequence.name().english(), {1.0, 0.5, 0.2}, all);
  }
  return rig;
}

} // namespace viscera::document
