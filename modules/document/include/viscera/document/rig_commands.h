#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/phrase.h"
#include "viscera/document/command.h"
#include "viscera/sequences/sequence.h"

/// Commands that change the handles, at rest and in the pose. All of them throw `UsageError` for handles and
/// groups that are not there. Texts, which may come from files, are converted to UTF-8, and missing names are
/// generated.
namespace viscera::document {

/// A handle that is to be added to a document.
struct NewHandle {
  Vec3 rest = Vec3::Zero();                 ///< mm, LPS.
  std::optional<Vec3> posed = std::nullopt; ///< Its place in the present pose; none: at rest.
  std::string label = {};                   ///< Empty: the next free "H-n". One that is taken gets a number.
  std::string description = {};
  bool locked = false;
  bool visible = true;
};

/// A new handle for every row of `positions` (`n x 3`), unlabelled.
std::vector<NewHandle> newHandles(const Points& positions);

/// Adds handles after the existing ones, in order, to `group` if one is given.
Command addHandles(std::vector<NewHandle> handles, GroupId group = {});

/// Adds the eight corners of a box around all organs and all handles, in a group of their own, "Enclosing".
/// The window offers this when vertices lie outside the handles' hull. Throws `UsageError` without any organ.
Command addEnclosingHandles();

/// Adds a group of eight new handles, the corners of a box around those vertices of an organ. The window
/// offers this when vertices lie in no group's region. Throws `UsageError` for an organ or vertices that are
/// not there.
Command addEnclosingGroup(OrganId organ, std::vector<int> vertices);

/// Removes handles, also from their groups, which stay. Removing a corner of the cage removes the cage, and
/// the convex hull is used instead.
Command removeHandles(std::vector<HandleId> handles);

/// Moves handles at rest to `positions` (`handles x 3`). A handle keeps its displacement in the pose: one at
/// rest stays at rest exactly. Locked ones stay where they are.
Command moveRestHandles(std::vector<HandleId> handles, Points positions);

/// Replaces the rig by another one, at rest: automatic placement, a file, a sequence's own handles. Handles
/// and groups get ids of the document, labels and names where there are none, and numbers behind those that
/// are taken. Throws `UsageError` for a group or a cage with a handle that the rig does not have.
Command replaceRig(Rig rig, Text name = "Replace handles");

/// The rig as `replaceRig` would put it into an empty document. Throws as above.
Rig completed(const Rig& rig);

/// The changes of a handle: label, lock, description, visibility, compensation. What is not given stays.
struct HandleEdit {
  std::optional<std::string> label;
  std::optional<std::string> description;
  std::optional<bool> locked;
  std::optional<bool> visible;
  std::optional<bool> compensates = std::nullopt;
};
Command editHandles(std::vector<HandleId> handles, HandleEdit change);

/// Moves handles in the pose to `positions` (`handles x 3` mm). Locked ones stay where they are. Throws
/// `UsageError` for a handle that is not there.
Command moveHandles(std::vector<HandleId> handles, Points positions);

/// Sets the whole pose (`n x 3` mm, in the order of the rig; not null), locked handles included. The document
/// shares it: nothing is copied. Throws `DataError` for another size.
Command setPose(std::shared_ptr<const Points> pose, Text name = "Set pose");
inline Command setPose(Points pose, Text name = "Set pose") {
  return setPose(std::make_shared<const Points>(std::move(pose)), std::move(name));
}

/// Resets the pose to the rest pose exactly, locked handles included.
Command resetPose();

/// Throws `DataError` when a sequence cannot move these handles: another number of them or another rest pose
/// (apart by more than 1e-6 of the size). The message proposes the sequence's own handles.
void requireFits(const Rig& rig, const sequences::Sequence& sequence);

/// The sequence's own handles, for `replaceRig`: in its groups, each handle labelled after its group.
Rig rigOf(const sequences::Sequence& sequence);

} // namespace viscera::document
