#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "viscera/scene/label_layout.h"
#include "viscera/scene/organ_actor.h"

#include "view_geometry.h"

namespace viscera::scene {

/// What is in front at places of the display, by its triangles: exact where a `FrontGrid`, which knows
/// vertices, is coarse.
class SeenPlaces {
public:
  /// What is nearest at a place, of what no plane cuts away.
  struct Seen {
    double depth = std::numeric_limits<double>::infinity(); ///< mm; that of a face where one is.
    const OrganActor* organ = nullptr;                      ///< Null: nothing.
    bool inside = false; ///< It faces away: one looks at its inside, which in a cut solid is behind its face.

    /// Whether the face of a cut is there.
    bool isFace() const { return organ && inside && organ->isCut() && organ->role() != SurfaceRole::hollow; }
  };

  SeenPlaces(const ViewGeometry& view, std::vector<ScreenPlace> places);

  /// Adds a surface. O(n + m) and what it takes to test its triangles near places.
  void look(const OrganActor& organ);
  const Seen& at(std::size_t place) const { return seen_[place]; }
  const ScreenPlace& placeOf(std::size_t place) const { return places_[place]; }

private:
  struct Corner {
    double x = 0, y = 0, depth = 0;
    bool away = false; ///< Cut away.
  };

  void meet(const OrganActor& organ, const Corner& a, const Corner& b, const Corner& c, std::size_t place,
            Seen& seen) const;
  double faceDepth(const OrganActor& organ, const ScreenPlace& place) const;

  const ViewGeometry view_;
  std::vector<ScreenPlace> places_;
  std::vector<Seen> seen_;
  std::size_t columns_, rows_;
  std::vector<std::vector<std::size_t>> inCell_; ///< The places in each cell of the display.
};

} // namespace viscera::scene
