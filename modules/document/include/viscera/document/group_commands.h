#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viscera/document/command.h"

/// Commands that change the groups of handles. All of them throw `UsageError` for groups and handles that are
/// not there.
namespace viscera::document {

/// Adds a group of handles that are there.
Command addGroup(std::string name, Vec3 color, std::vector<HandleId> handles);
/// Removes a group; its handles stay.
Command removeGroup(GroupId group);
/// A name, a colour, other members. What is not given stays. Colours that follow each other join one step
/// until `UndoStack::seal`.
struct GroupEdit {
  std::optional<std::string> name;
  std::optional<Vec3> color;
  std::optional<std::vector<HandleId>> handles;
};
Command editGroup(GroupId group, GroupEdit change);
/// Puts handles into a group, or takes them out of it.
Command addToGroup(GroupId group, std::vector<HandleId> handles);
Command removeFromGroup(GroupId group, std::vector<HandleId> handles);

} // namespace viscera::document
