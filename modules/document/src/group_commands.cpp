#include "viscera/document/group_commands.h"

#include <set>
#include <utility>

#include "viscera/document/edit.h"

namespace viscera::document {
namespace {

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

/// The state with one group replaced by what `change` makes of it.
DocumentState withGroup(const DocumentState& state, GroupId id,
                        const std::function<void(const Rig& rig, Group&)>& change) {
  Rig rig = *state.rig;
  const int place = rig.indexOf(id);
  if (place < 0)
    throw UsageError("There is no such group any more", "group " + std::to_string(id.value));
  change(*state.rig, rig.groups[static_cast<std::size_t>(place)]);
  return edit::withRig(state, std::move(rig));
}

} // namespace

Command addGroup(std::string name, Vec3 color, std::vector<HandleId> handles) {
  return {"Add group " + name,
          [name, color, handles = std::move(handles)](const DocumentState& state, IdSource& ids) {
            Rig rig = *state.rig;
            Group group{ids.next<GroupId>(), name, color, inOrder(rig, handles)};
            rig.groups.push_back(std::move(group));
            return edit::withRig(state, std::move(rig));
          },
          {}};
}

Command removeGroup(GroupId group) {
  return {"Remove group",
          [group](const DocumentState& state, IdSource&) {
            Rig rig = *state.rig;
            const int place = rig.indexOf(group);
            if (place < 0)
              throw UsageError("There is no such group any more", "group " + std::to_string(group.value));
            rig.groups.erase(rig.groups.begin() + place);
            return edit::withRig(state, std::move(rig));
          },
          {}};
}

Command editGroup(GroupId group, GroupEdit change) {
  const bool onlyColor = change.color && !change.name && !change.handles;
  return {change.name ? "Rename group"
          : onlyColor ? "Colour group"
                      : "Change group",
          [group, change = std::move(change)](const DocumentState& state, IdSource&) {
            return withGroup(state, group, [&](const Rig& rig, Group& changed) {
              changed.name = change.name.value_or(changed.name);
              changed.color = change.color.value_or(changed.color);
              if (change.handles)
                changed.handles = inOrder(rig, *change.handles);
            });
          },
          onlyColor ? "group color/" + std::to_string(group.value) : std::string()};
}

Command addToGroup(GroupId group, std::vector<HandleId> handles) {
  return {"Add to group",
          [group, handles = std::move(handles)](const DocumentState& state, IdSource&) {
            return withGroup(state, group, [&](const Rig& rig, Group& changed) {
              changed.handles.insert(changed.handles.end(), handles.begin(), handles.end());
              changed.handles = inOrder(rig, changed.handles);
            });
          },
          {}};
}

Command removeFromGroup(GroupId group, std::vector<HandleId> handles) {
  return {"Remove from group",
          [group, handles = std::move(handles)](const DocumentState& state, IdSource&) {
            return withGroup(state, group, [&](const Rig&, Group& changed) {
              std::erase_if(changed.handles, [&](HandleId id) {
                return std::find(handles.begin(), handles.end(), id) != handles.end();
              });
            });
          },
          {}};
}

} // namespace viscera::document
