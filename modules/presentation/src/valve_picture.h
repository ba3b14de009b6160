#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "heart_picture.h"
#include "organ_picture.h"
#include "viscera/heart/heart_chords.h"
#include "viscera/heart/heart_valves.h"
#include "viscera/presentation/presenter.h"
#include "viscera/scene/valve_glyphs.h"

namespace viscera::presentation {

/// Draws the valves of the sample heart while it beats, and arrows for the flow through them.
class ValvePicture {
public:
  explicit ValvePicture(scene::OrganView& view) { glyphs_.setRenderer(view.renderer()); }

  /// Updates leaflets and arrows to the present pose of the heart. A valve that a cut touches is drawn whole;
  /// a valve within the part that is cut away is not drawn. A heart that is cut open (`opened`) and empty
  /// shows its valves shut where it does not beat, and one that is cut open shows their chords, but those
  /// whose muscle is cut away.
  void update(const Scene& scene, const std::optional<scene::CutPlane>& cut, const HeartPicture& opened);
  /// Makes the cavities transparent in their appearances, so that the valves in them are visible.
  void apply(const Scene& scene, std::map<document::OrganId, Appearance>& appearances) const;

  /// Where the names of the chords are on them: a point for each valve that has drawn ones, with its
  /// ventricle. The points follow the pose.
  std::vector<std::pair<document::OrganId, Eigen::Index>> chordNames() const;
  const std::shared_ptr<Points>& chordPoints() const { return chordPoints_; }
  const scene::ValveGlyphs& glyphs() const { return glyphs_; }

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
    std::uint64_t opened = 0; ///< The revision of the opened heart.
    bool operator==(const Moment&) const = default;
  };
  /// The cavities of the left and right ventricle, and of the atria if there are any.
  struct Heart {
    std::array<std::shared_ptr<const document::Organ>, 2> ventricles;
    std::vector<std::shared_ptr<const document::Organ>> atria;
  };

  std::optional<heart::ValveInstants> valvesOf(const Scene& scene) const;
  std::optional<Heart> heartOf(const Scene& scene) const;
  void draw(const heart::ValveInstants& valves, const Moment& moment, const HeartPicture& opened);
  void updateChords(const HeartPicture& opened);
  std::vector<Points> chordsOf(heart::HeartValve valve, const heart::Leaflets& leaflets,
                               const heart::ValveRing& ring, const Moment& moment, const Points& walls) const;

  scene::ValveGlyphs glyphs_;
  std::array<Carrier, 2> carriers_;
  std::optional<Moment> drawn_; ///< None: nothing is drawn.
  bool opened_ = false;
  /// The chords of the tissue that is drawn, and what they hold on to.
  std::shared_ptr<const geometry::TriangleMesh> chordsMesh_;
  std::optional<heart::HeartChords> chords_;
  std::array<document::OrganId, 2> ventricles_;
  std::shared_ptr<Points> chordPoints_ = std::make_shared<Points>(Points::Zero(2, 3));
  std::array<bool, 2> chordsDrawn_{}; ///< Of each side.
};

} // namespace viscera::presentation
