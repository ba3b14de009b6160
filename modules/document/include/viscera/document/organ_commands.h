#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viscera/document/command.h"
#include "viscera/medical_io/image_cut.h"

namespace viscera::document {

/// An organ that is to be added to a document.
struct NewOrgan {
  Organ organ; ///< From `makeOrgan`; it gets its id when it is added, and `parent` may be an organ of the
               ///< document.
  int parentInBatch = -1; ///< Or the index of its parent among the organs added with it.
  /// The report of its surface as it was read, before `makeOrgan`; none: no file was read.
  std::optional<geometry::SurfaceReport> report = {};
  std::optional<medical_io::ImageCut> cut = {}; ///< The edges of its label map that cut it off.
};

/// Adds organs after the existing ones, in order. A name that is taken gets a number ("Liver 2"); names and
/// remarks, which may come from files, are converted to UTF-8, and an organ without a name is called "Organ".
Command addOrgans(std::vector<NewOrgan> organs);

/// Removes organs and the cavities inside them. Throws `UsageError` for an organ that is not there.
Command removeOrgans(std::vector<OrganId> organs);
/// Removes all organs.
Command removeAllOrgans();

/// Sets how an organ is shown. Commands for the same organ that follow each other join one step until
/// `UndoStack::seal`.
Command setOrganLook(OrganId organ, OrganLook look);

/// Locks or unlocks an organ's volume: with it locked, no motion of handles in the pose changes it
/// (volume_keeper.h). Throws `DataError` for an open surface (it says how many edges are open), `UsageError`
/// for an organ that is not there.
Command setVolumeLocked(OrganId organ, bool locked);

/// Sets how organs follow the handles: they bend, move as rigid bodies or stay; each is bound anew. Throws
/// `UsageError` for an organ that is not there.
Command setMobility(std::vector<OrganId> organs, Mobility mobility);

/// Fills the holes of an organ's surface (`geometry::closeHoles`), which thereby gets a volume; the organ
/// stays what it is otherwise, and is bound anew. Throws `DataError` when it cannot be closed, `UsageError`
/// for an organ that is not there. O(m log m).
Command closeHoles(OrganId organ);

/// Gives an organ another name.
Command renameOrgan(OrganId organ, std::string name);

} // namespace viscera::document
