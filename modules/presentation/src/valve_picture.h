#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "organ_picture.h"
#include "viscera/presentation/presenter.h"
#include "viscera/scene/valve_glyphs.h"
#include "viscera/sequences/heart_valves.h"

namespace viscera::presentation {

/// The valves of the sample heart while it beats, and what flows through them.
class ValvePicture {
public:
  explicit ValvePicture(scene::OrganView& view) { glyphs_.setRenderer(view.renderer()); }

  /// Brings leaflets and arrows to where the heart is now. A valve that a cut touches is drawn whole; one
  /// that lies in what is cut away, not at all.
  void update(const Scene& scene, const std::optional<scene::CutPlane>& cut);
  /// Lets one look through the cavities at what is in them, on top of how they are seen anyway.
  void apply(const Scene& scene, std::map<document::OrganId, Appearance>& appearances) const;

private:
  /// A cavity with the rings of its two valves.
  struct Carrier {
    std::shared_ptr<const geometry::TriangleMesh> mesh;
    std::vector<sequences::CarriedRing> rings;
  };
  /// What was drawn last.
  struct Moment {
    sequences::ValveInstants valves;
    std::array<std::pair<std::shared_ptr<const Points>, std::uint64_t>, 2> surfaces;
    std::optional<scene::CutPlane> cut;
    bool operator==(const Moment&) const = default;
  };
  /// The ventricles' cavities, left and right, and those of the atria that there are.
  struct Heart {
    std::array<std::shared_ptr<const document::Organ>, 2> ventricles;
    std::vector<std::shared_ptr<const document::Organ>> atria;
  };

  std::optional<Heart> heartOf(const Scene& scene) const;
  void draw(const sequences::ValveInstants& valves, const Moment& moment);

  scene::ValveGlyphs glyphs_;
  std::array<Carrier, 2> carriers_;
  std::optional<Moment> drawn_; ///< None: nothing is drawn.
};

} // namespace viscera::presentation
