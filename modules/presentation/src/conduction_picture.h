#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "organ_picture.h"
#include "viscera/geometry/carried_points.h"
#include "viscera/presentation/presenter.h"
#include "viscera/scene/conduction_glyphs.h"

namespace viscera::presentation {

/// Draws the conduction system of a heart (`document::Organ::ways`), carried by its surfaces, and lights it
/// where the excitation is at the instant of the beat that is shown.
class ConductionPicture {
public:
  explicit ConductionPicture(scene::OrganView& view) { glyphs_.setRenderer(view.renderer()); }

  /// Updates the lines to the present pose and instant. What a cut takes away is not drawn.
  void update(const Scene& scene, const std::optional<scene::CutPlane>& cut);
  /// Makes the surfaces around the lines transparent in their appearances; the outer one only while nothing
  /// is cut open.
  void apply(const Scene& scene, std::map<document::OrganId, Appearance>& appearances) const;
  bool drawn() const { return drawn_.has_value(); }
  const scene::ConductionGlyphs& glyphs() const { return glyphs_; }

private:
  /// A surface with the lines that it carries.
  struct Carrier {
    std::shared_ptr<const geometry::TriangleMesh> mesh;
    std::vector<geometry::CarriedPoints> lines;
  };
  /// What was drawn last.
  struct Moment {
    std::map<document::OrganId, std::pair<std::shared_ptr<const Points>, std::uint64_t>> surfaces;
    std::optional<heart::BeatClock> clock;
    std::optional<scene::CutPlane> cut;
    bool operator==(const Moment&) const = default;
  };

  void draw(const Scene& scene, const Moment& moment);

  scene::ConductionGlyphs glyphs_;
  std::map<document::OrganId, Carrier> carriers_;
  std::optional<Moment> drawn_; ///< None: nothing is drawn.
};

} // namespace viscera::presentation
