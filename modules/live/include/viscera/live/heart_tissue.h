#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/document/document.h"
#include "viscera/geometry/carried_points.h"
#include "viscera/live/heart_blood.h"
#include "viscera/live/heart_vessels.h"
#include "viscera/live/posed_organs.h"
#include "viscera/sample_organs/sample_organ.h"

/// The walls of the sample heart, which a cut shows in place of the surfaces that volumes come from.
namespace viscera::live {

/// The sample heart of a document: the surface around it and its cavities, in the document's order.
struct SampleHeartOrgans {
  std::shared_ptr<const document::Organ> outer; ///< Never null.
  std::vector<std::shared_ptr<const document::Organ>> cavities;
};

/// The first sample heart of a document whose outer surface is visible; none where there is none. O(organs).
std::optional<SampleHeartOrgans> sampleHeartIn(const document::DocumentState& state);

/// Whether two are the same surfaces at rest, in whatever pose and look. O(1).
bool sameSurfaces(const SampleHeartOrgans& a, const SampleHeartOrgans& b);

/// The surfaces and lines at rest of which the picture of an opened heart is made.
struct HeartSurfaces {
  std::shared_ptr<const geometry::TriangleMesh> tissue; ///< Never null.
  /// The surfaces that the tissue's inside was made from, left and right; null: no blood is drawn.
  std::array<std::shared_ptr<const geometry::TriangleMesh>, 2> lumina = {};
  std::vector<geometry::NamedVessel> vessels = {};
  /// What fills the fold between the atria; null: nothing.
  std::shared_ptr<const geometry::TriangleMesh> septum = nullptr;
};

/// The heart's walls with papillary muscles as one closed surface, open through the valves' rings and at the
/// ends of the vessels, with the coronary vessels on them, the fat between the atria, and the blood that may
/// fill them. It is no organ of the document, and follows no handles by itself: the heart's surfaces carry it
/// (`geometry::CarriedPoints`), so that it goes along with whatever moves them. Immutable; thread-safe.
class HeartTissue {
public:
  /// `heart` is what carries it. O(vertices), some 0.1 s.
  HeartTissue(HeartSurfaces surfaces, const SampleHeartOrgans& heart, Threads threads = {});

  const std::shared_ptr<const geometry::TriangleMesh>& mesh() const { return mesh_; } ///< At rest.
  /// Whether these are the surfaces that carry it.
  bool isOf(const SampleHeartOrgans& heart) const { return sameSurfaces(heart_, heart); }
  /// Writes its vertices as they are in the pose of the organs, `n x 3` mm, where `isOf(heart)`.
  void at(const SampleHeartOrgans& heart, const PosedOrgans& organs, Points& out, Threads threads = {}) const;
  /// The vertices that carry it as they are in the pose of the organs, for the vessels and the blood.
  Points carriersAt(const SampleHeartOrgans& heart, const PosedOrgans& organs) const;
  void at(const Points& carriers, Points& out, Threads threads = {}) const;

  const HeartVessels& vessels() const { return vessels_; }
  /// The fat in the fold between the atria, a closed surface at rest that reaches a little into both walls,
  /// and so closes the gap between them in every pose; null where it is not known.
  const std::shared_ptr<const geometry::TriangleMesh>& septum() const { return septum_; }
  /// Writes the vertices of `septum` for the carriers as they are now.
  void septumAt(const Points& carriers, Points& out, Threads threads = {}) const;
  /// The blood of the left side, then of the right; null where it is not known.
  const std::array<std::unique_ptr<const HeartBlood>, 2>& blood() const { return blood_; }

private:
  std::shared_ptr<const geometry::TriangleMesh> mesh_;
  SampleHeartOrgans heart_;
  geometry::CarriedPoints carried_;
  HeartVessels vessels_;
  std::shared_ptr<const geometry::TriangleMesh> septum_;
  std::optional<geometry::CarriedPoints> carriedSeptum_;
  std::array<std::unique_ptr<const HeartBlood>, 2> blood_;
};

/// The tissue of a heart, from the cache of the library or made (seconds). Null where the heart's outer
/// surface is not the one that the library makes, as in a session of an older version. Throws what
/// `sample_organs::sampleSurface` throws.
std::shared_ptr<const HeartTissue> makeHeartTissue(const SampleHeartOrgans& heart,
                                                   const sample_organs::SampleLibrary& library,
                                                   Progress& progress, Threads threads = {});

} // namespace viscera::live
