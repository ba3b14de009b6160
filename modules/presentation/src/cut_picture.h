#pragma once

#include <map>
#include <optional>

#include "heart_picture.h"
#include "organ_picture.h"
#include "viscera/presentation/presenter.h"
#include "viscera/scene/cut_caps.h"

namespace viscera::presentation {

/// Cuts the organs open by a plane (the stress map has a cut of its own): hides what lies on one side of it
/// and draws the cut faces of walls, so that cavities are open.
class CutPicture {
public:
  explicit CutPicture(scene::OrganView& view) { caps_.setRenderer(view.renderer()); }

  /// Updates the cut faces to the present organs. That of an opened heart is its tissue's; blood fills the
  /// rest of it.
  void update(const Scene& scene, const HeartPicture& heart);
  /// Adds the cut to the appearances of all visible organs.
  void apply(const Scene& scene, std::map<document::OrganId, Appearance>& appearances) const;
  /// The plane, while there is one.
  const std::optional<scene::CutPlane>& plane() const { return plane_; }

private:
  std::vector<scene::CutCaps::Face> facesOf(const Scene& scene, const HeartPicture& heart) const;

  scene::CutCaps caps_;
  std::optional<scene::CutPlane> plane_;
  /// The state of the organs for which the faces were drawn.
  using Moment = std::map<document::OrganId, std::pair<std::shared_ptr<const Points>, std::uint64_t>>;
  Moment moment_;
  std::uint64_t heart_ = 0; ///< The revision of the opened heart.
  std::shared_ptr<const document::OrganList> organs_;
};

} // namespace viscera::presentation
