#pragma once

#include <functional>

#include "handle_owners.h"
#include "viscera/presentation/presenter.h"

/// Draws the handles of a document in a 3D view, with the gizmo and the mirror plane.
namespace viscera::presentation {

/// Returns whether handles at a place are shown; null: they are shown everywhere.
using ShownWhere = std::function<bool(const Vec3&)>;

/// The displayed positions of the handles, `n x 3` mm, in the order of the rig.
Points handlePlaces(const document::DocumentState& state, const live::PosedOrgans& organs);

/// The colours of the handles, one row each, from their groups; `tinted`: compensating handles are
/// highlighted.
Colors handleColors(const document::Rig& rig, bool tinted);

/// Updates the handles of a view from document, pose and selection, and the tools around them.
class HandlePicture {
public:
  explicit HandlePicture(scene::OrganView& view);

  void update(const Scene& scene, const ShownWhere& shownWhere);

private:
  void updateGizmo(const Scene& scene);
  void updateMirror(const Scene& scene);

  scene::OrganView& view_;
  HandleOwners owners_;
};

} // namespace viscera::presentation
