#pragma once

#include <functional>

#include "handle_owners.h"
#include "viscera/presentation/presenter.h"

namespace viscera::presentation {

/// Places at which handles are seen; null: everywhere.
using ShownWhere = std::function<bool(const Vec3&)>;

/// The handles where they are shown, `n x 3` mm, in the order of the rig.
Points handlePlaces(const document::DocumentState& state, const live::PosedOrgans& organs);

/// Their colours, one a row: their groups'; `tinted`: those that compensate stand out.
Colors handleColors(const document::Rig& rig, bool tinted);

/// The handles of a view as the document, the pose and the selection have them, and the tools around them.
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
