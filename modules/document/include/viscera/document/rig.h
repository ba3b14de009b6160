#pragma once

#include <array>
#include <string>
#include <vector>

#include "viscera/coordinates/handle_set.h"
#include "viscera/core/arrays.h"
#include "viscera/core/phrase.h"
#include "viscera/document/ids.h"

namespace viscera::document {

/// A handle of the document: its position at rest and its properties.
struct Handle {
  HandleId id;
  std::string label;        ///< "H-1"; unique in the rig.
  Vec3 rest = Vec3::Zero(); ///< mm, LPS.
  bool locked = false;      ///< A locked handle is moved by no command, neither at rest nor in the pose.
  bool visible = true;
  std::string description; ///< Free text, kept for the files that have it.
  /// Moves to compensate for changes of a locked volume by other handles. If no handle is marked so, all free
  /// ones compensate.
  bool compensates = false;

  friend bool operator==(const Handle&, const Handle&) = default;
};

/// A group of handles with a name and a colour. A handle may be in several groups (regions that overlap) or
/// in none.
struct Group {
  GroupId id;
  std::string name;              ///< Unique in the rig.
  Vec3 color = {1.0, 0.5, 0.2};  ///< Red green blue, 0 to 1.
  std::vector<HandleId> handles; ///< Each once, in the order of the rig.

  friend bool operator==(const Group&, const Group&) = default;
};

/// The corners of one triangle of a cage, counter-clockwise seen from outside.
using CageTriangle = std::array<HandleId, 3>;

/// Handles with their labels, groups and cage, at rest: those that all organs of a document share, or those
/// of a file, a sequence or an automatic placement, which `replaceRig` puts into a document. The order of the
/// handles is that of the rows of every pose.
struct Rig {
  std::vector<Handle> handles;
  std::vector<Group> groups;
  /// The closed surface over handles at rest that systems with a cage work with; empty: the convex hull of
  /// all handles.
  std::vector<CageTriangle> cage;

  /// Rest positions, `n x 3` mm.
  Points restPositions() const;
  /// The row of a handle, or -1.
  int indexOf(HandleId id) const;
  /// The place of a group in `groups`, or -1.
  int indexOf(GroupId id) const;
  /// The handle with that label, or -1.
  int indexOf(const std::string& label) const;
  /// The first group that a handle is in (it gives the handle its colour), or null.
  const Group* groupOf(HandleId id) const;

  /// Appends a group of the handles in these rows, with an id of its own in the rig. Throws `UsageError` for
  /// a row that does not exist.
  void addGroup(std::string name, const Vec3& color, const std::vector<int>& rows);

  /// How many handles are corners of the given cage.
  int cornerCount() const;

  friend bool operator==(const Rig&, const Rig&) = default;
};

/// Handles at `positions` (`n x 3` mm), without labels and groups. Their ids count from 1: they are those of
/// no document.
Rig rigAt(const Points& positions);

/// Describes handles for a user: "handle H-3", or "5 handles".
Text describe(const Rig& rig, const std::vector<HandleId>& handles);

/// The rig as the input of a coordinate system: positions, groups, and the given cage, if any.
coordinates::HandleSet handleSet(const Rig& rig);

} // namespace viscera::document
