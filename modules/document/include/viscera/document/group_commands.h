#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viscera/deformation/group_handles.h"
#include "viscera/document/command.h"

/// Commands that add, change and remove groups of handles, and make groups automatically. The commands throw
/// `UsageError` for groups and handles that are not there.
namespace viscera::document {

/// Adds a group of existing handles.
Command addGroup(std::string name, Vec3 color, std::vector<HandleId> handles);
/// Removes a group; its handles stay.
Command removeGroup(GroupId group);
/// The changes of a group: a new name, colour or other members. What is not given stays. Colours that follow
/// each other join one step until `UndoStack::seal`.
struct GroupEdit {
  std::optional<std::string> name;
  std::optional<Vec3> color;
  std::optional<std::vector<HandleId>> handles;
};
Command editGroup(GroupId group, GroupEdit change);
/// Puts handles into a group, or takes them out of it.
Command addToGroup(GroupId group, std::vector<HandleId> handles);
Command removeFromGroup(GroupId group, std::vector<HandleId> handles);

/// The method and options of automatic grouping.
struct GroupingChoice {
  enum class By {
    organ,  ///< One group for each organ, and for each of its connected pieces.
    axis,   ///< `count` parts along the longest axis of all organs; neighbours overlap.
    cluster ///< `count` clusters of handles that are near to each other; neighbours overlap.
  };
  By by = By::axis;
  int count = 3;
};

/// "organ", "axis", "cluster". Throws `UsageError` that lists them for anything else.
GroupingChoice::By groupingFromName(const std::string& name);

/// A colour for the group of that number, from a palette that the colour-blind can tell apart (after Okabe
/// and Ito); it begins anew after seven.
Vec3 groupColor(std::size_t number);

/// The description of handles that `groupAutomatically` has added.
inline constexpr const char* kAddedByGrouping = "added by automatic grouping";

/// The groups of `handles` (`n x 3` mm) for these organs. Pieces with less than a fiftieth of an organ's
/// vertices, and its cavities, go with its largest piece. Throws as the functions of group_handles.h do, and
/// `UsageError` without organs.
deformation::Grouping makeGroups(const GroupingChoice& choice, const OrganList& organs,
                                 const Points& handles);

/// Replaces all groups by new ones, in one step. Handles that an earlier automatic grouping had added are
/// removed; where the others do not surround a group's part of the organs, corners of a box around it are
/// added. The pose of the handles that stay is kept.
Command groupAutomatically(const GroupingChoice& choice);

} // namespace viscera::document
