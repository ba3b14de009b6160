#pragma once

#include <map>
#include <optional>

#include "organ_picture.h"
#include "viscera/presentation/presenter.h"
#include "viscera/scene/cut_caps.h"

namespace viscera::presentation {

/// Organs that a plane cuts open, outside of the stress map, which has a cut of its own: what lies on one
/// side is gone, walls have a face where they were cut, cavities are open.
class CutPicture {
public:
  explicit CutPicture(scene::OrganView& view) { caps_.setRenderer(view.renderer()); }

  /// Brings the faces to the organs as they are now.
  void update(const Scene& scene);
  /// Cuts all organs that are seen, on top of how they are seen anyway.
  void apply(const Scene& scene, std::map<document::OrganId, Appearance>& appearances) const;
  /// The plane, while there is one.
  const std::optional<scene::CutPlane>& plane() const { return plane_; }

private:
  std::vector<scene::CutCaps::Face> facesOf(const Scene& scene) const;

  scene::CutCaps caps_;
  std::optional<scene::CutPlane> plane_;
  /// What the organs were like whose faces are drawn.
  using Moment = std::map<document::OrganId, std::pair<std::shared_ptr<const Points>, std::uint64_t>>;
  Moment moment_;
  std::shared_ptr<const document::OrganList> organs_;
};

/// The plane of a cut through a document: its offset is of the ball around the organs at rest, so that the
/// plane stands still while they move.
scene::CutPlane planeOf(const OrganCut& cut, const document::DocumentState& state);

} // namespace viscera::presentation
