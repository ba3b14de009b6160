#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "organ_picture.h"
#include "viscera/heart/heart_valves.h"
#include "viscera/presentation/presenter.h"
#include "viscera/scene/valve_glyphs.h"

namespace viscera::presentation {

/// Draws the valves of the sample heart while it beats, and arrows for the flow through them.
class ValvePicture {
public:
  explicit ValvePicture(scene::OrganView& view) { glyphs_.setRenderer(view.renderer()); }

  /// Updates leaflets and arrows to the present pose of the heart. A valve that a cut touches is drawn whole;
  /// a valve within the part that is cut away is not drawn. `opened`: the heart is cut open and empty, so
  /// that one that does not beat shows its valves shut.
  void update(const Scene& scene, const std::optional<scene::CutPlane>& cut, bool opened);
  /// Makes the cavities transparent in their appearances, so that the valves in them are visible.
  void apply(const Scene& scene, std::map<document::OrganId, Appearance>& appearances) const;

private:
  /// A cavity with the rings of its two valves.
  struct Carrier {
    std::shared_ptr<const geometry::TriangleMesh> mesh;
    std::vector<heart::CarriedRing> rings;
  };
  /// The state in which the valves were drawn last.
  struct Moment {
    heart::ValveInstants valves;
    std::array<std::pair<std::shared_ptr<const Points>, std::uint64_t>, 2> surfaces;
    std::optional<scene::CutPlane> cut;
    bool operator==(const Moment&) const = default;
  };
  /// The cavities of the left and right ventricle, and of the atria if there are any.
  struct Heart {
    std::array<std::shared_ptr<const document::Organ>, 2> ventricles;
    std::vector<std::shared_ptr<const document::Organ>> atria;
  };

  std::optional<heart::ValveInstants> valvesOf(const Scene& scene) const;
  std::optional<Heart> heartOf(const Scene& scene) const;
  void draw(const heart::ValveInstants& valves, const Moment& moment);

  scene::ValveGlyphs glyphs_;
  std::array<Carrier, 2> carriers_;
  std::optional<Moment> drawn_; ///< None: nothing is drawn.
  bool opened_ = false;
};

} // namespace viscera::presentation
