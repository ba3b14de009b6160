#include "viscera/document/group_commands.h"

#include <array>
#include <map>
#include <set>
#include <utility>

#include "viscera/core/phrase.h"
#include "viscera/document/edit.h"
#include "viscera/document/rig_commands.h"
#include "viscera/geometry/connected_pieces.h"

namespace viscera::document {
namespace {

constexpr const char* kGroupKind = "group";

using By = GroupingChoice::By;

/// A piece of an organ with fewer of its vertices is a splinter of the scan, not a part of its own.
constexpr double kSplinter = 0.02;

/// The members in the order of the rig, each once. Throws for one that is not there.
std::vector<HandleId> inOrder(const Rig& rig, const std::vector<HandleId>& handles) {
  std::set<int> rows;
  for (const HandleId id : handles)
    rows.insert(edit::requireHandle(rig, id));
  std::vector<HandleId> ordered;
  for (const int row : rows)
    ordered.push_back(rig.handles[static_cast<std::size_t>(row)].id);
  return ordered;
}

/// The vertices of each piece of a surface that counts; those of the others go with the largest.
std::vector<std::vector<int>> piecesOf(const geometry::TriangleMesh& mesh) {
  const geometry::ConnectedPieces pieces = geometry::connectedPieces(mesh);
  std::vector<std::vector<int>> vertices(static_cast<std::size_t>(std::max(pieces.count, 1)));
  std::vector<int> others;
  for (std::size_t v = 0; v < pieces.ofVertex.size(); ++v)
    (pieces.ofVertex[v] < 0 ? others : vertices[static_cast<std::size_t>(pieces.ofVertex[v])])
        .push_back(static_cast<int>(v));
  const auto bySize = [](const auto& a, const auto& b) { return a.size() < b.size(); };
  const auto largest = std::max_element(vertices.begin(), vertices.end(), bySize);
  std::vector<int> main = std::move(*largest);
  vertices.erase(largest);
  std::vector<std::vector<int>> kept;
  for (auto& piece : vertices) {
    if (static_cast<double>(piece.size()) < kSplinter * static_cast<double>(pieces.ofVertex.size()))
      main.insert(main.end(), piece.begin(), piece.end());
    else
      kept.push_back(std::move(piece));
  }
  main.insert(main.end(), others.begin(), others.end());
  kept.insert(kept.begin(), std::move(main));
  return kept;
}

deformation::Grouping byOrgan(const OrganList& organs, const Points& handles) {
  std::vector<Points> parts;
  std::vector<std::string> names;
  std::map<OrganId, std::size_t> mainPiece;
  for (const auto& organ : organs) {
    if (organ->parent)
      continue;
    const auto pieces = piecesOf(*organ->mesh);
    mainPiece[organ->id] = parts.size();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      parts.push_back(organ->mesh->points(pieces[i], Eigen::all));
      names.push_back(pieces.size() == 1 ? organ->name : organ->name + " " + std::to_string(i + 1));
    }
  }
  for (const auto& organ : organs)
    if (const auto home = mainPiece.find(organ->parent); organ->parent && home != mainPiece.end())
      parts[home->second] = edit::joined(parts[home->second], organ->mesh->points);
  return deformation::groupsByOrgan(handles, parts, names);
}

/// The state without the handles that an earlier grouping added.
DocumentState withoutAdded(const DocumentState& state, IdSource& ids) {
  std::vector<HandleId> added;
  for (const Handle& handle : state.rig->handles)
    if (handle.description == kAddedByGrouping && !handle.locked)
      added.push_back(handle.id);
  return added.empty() ? state : removeHandles(added).apply(state, ids);
}

DocumentState regrouped(const GroupingChoice& choice, const DocumentState& before, IdSource& ids) {
  if (before.rig->handles.empty())
    throw UsageError("There are no handles to group", {}, "place some first");
  DocumentState state = withoutAdded(before, ids);
  const deformation::Grouping grouping = makeGroups(choice, *state.organs, state.rig->restPositions());
  if (grouping.added.rows() > 0) {
    std::vector<NewHandle> corners = newHandles(grouping.added);
    for (NewHandle& corner : corners)
      corner.description = kAddedByGrouping;
    state = addHandles(std::move(corners)).apply(state, ids);
  }
  Rig rig = *state.rig;
  rig.groups.clear();
  for (const auto& group : grouping.groups) {
    const auto taken = [&rig](const std::string& name) {
      return std::any_of(rig.groups.begin(), rig.groups.end(),
                         [&name](const Group& other) { return other.name == name; });
    };
    Group made{ids.next<GroupId>(), edit::freeName(group.name, taken), groupColor(rig.groups.size()), {}};
    for (const int row : group.handles)
      made.handles.push_back(rig.handles[static_cast<std::size_t>(row)].id);
    rig.groups.push_back(std::move(made));
  }
  state.rig = std::make_shared<const Rig>(std::move(rig));
  return state;
}

} // namespace

Command addGroup(std::string name, Vec3 color, std::vector<HandleId> handles) {
  return edit::onPart(
      phrase("Add group %1", named(name)), &DocumentState::rig,
      [name, color, handles = std::move(handles)](Rig& rig, const DocumentState&, IdSource& ids) {
        rig.groups.push_back({ids.next<GroupId>(), name, color, inOrder(rig, handles)});
      });
}

Command removeGroup(GroupId group) {
  return edit::onPart("Remove group", &DocumentState::rig,
                      [group](Rig& rig) { edit::remove(rig.groups, std::vector{group}, kGroupKind); });
}

Command editGroup(GroupId group, GroupEdit change) {
  const bool onlyColor = change.color && !change.name && !change.handles;
  return edit::onPart(
      change.name ? "Rename group"
      : onlyColor ? "Colour group"
                  : "Change group",
      &DocumentState::rig,
      [group, change](Rig& rig) {
        Group& changed = edit::require(rig.groups, group, kGroupKind);
        changed.name = change.name.value_or(changed.name);
        changed.color = change.color.value_or(changed.color);
        if (change.handles)
          changed.handles = inOrder(rig, *change.handles);
      },
      onlyColor ? "group color/" + std::to_string(group.value) : std::string());
}

Command addToGroup(GroupId group, std::vector<HandleId> handles) {
  return edit::onPart("Add to group", &DocumentState::rig, [group, handles = std::move(handles)](Rig& rig) {
    std::vector<HandleId>& members = edit::require(rig.groups, group, kGroupKind).handles;
    members.insert(members.end(), handles.begin(), handles.end());
    members = inOrder(rig, members);
  });
}

Command removeFromGroup(GroupId group, std::vector<HandleId> handles) {
  return edit::onPart("Take out of group", &DocumentState::rig,
                      [group, handles = std::move(handles)](Rig& rig) {
                        std::erase_if(edit::require(rig.groups, group, kGroupKind).handles, [&](HandleId id) {
                          return std::find(handles.begin(), handles.end(), id) != handles.end();
                        });
                      });
}

GroupingChoice::By groupingFromName(const std::string& name) {
  for (const auto& [by, text] :
       {std::pair{By::organ, "organ"}, std::pair{By::axis, "axis"}, std::pair{By::cluster, "cluster"}})
    if (name == text)
      return by;
  throw UsageError(misuse("there is no way \"%1\" to make groups", name), {},
                   misuse("choose organ, axis or cluster"));
}

Vec3 groupColor(std::size_t number) {
  static const std::array<Vec3, 7> kPalette = {
      Vec3(0.90, 0.62, 0.00), Vec3(0.34, 0.71, 0.91), Vec3(0.80, 0.47, 0.65), Vec3(0.94, 0.89, 0.26),
      Vec3(0.00, 0.62, 0.45), Vec3(0.84, 0.37, 0.00), Vec3(0.00, 0.45, 0.70)};
  return kPalette[number % kPalette.size()];
}

deformation::Grouping makeGroups(const GroupingChoice& choice, const OrganList& organs,
                                 const Points& handles) {
  if (organs.empty())
    throw UsageError("There is no organ to make groups for", {}, "open one first");
  switch (choice.by) {
  case By::organ:
    return byOrgan(organs, handles);
  case By::cluster:
    return deformation::groupsByCluster(handles, edit::allPoints(organs), choice.count);
  case By::axis:
    break;
  }
  return deformation::groupsAlongAxis(handles, edit::allPoints(organs), choice.count);
}

Command groupAutomatically(const GroupingChoice& choice) {
  return {"Group automatically",
          [choice](const DocumentState& state, IdSource& ids) { return regrouped(choice, state, ids); }};
}

} // namespace viscera::document
