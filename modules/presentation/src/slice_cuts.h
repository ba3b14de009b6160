#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "viscera/document/document.h"
#include "viscera/document/organ.h"
#include "viscera/geometry/plane_cut.h"
#include "viscera/live/posed_organs.h"

namespace viscera::presentation {

/// Computes the contours in which planes cut a document's organs, posed and at rest. Only cuts organs again
/// that have moved.
class SliceCuts {
public:
  /// An organ that is seen, and its cut by every plane.
  struct Organ {
    std::shared_ptr<const document::Organ> organ;
    std::vector<geometry::PlaneCut> posed;
    std::vector<geometry::PlaneCut> rest; ///< Empty if the organ is at rest, or if not requested.
  };

  explicit SliceCuts(Threads threads) : threads_(threads) {}

  /// Updates the cuts of all visible organs by `planes`; with `rest` also those of the organs at rest, while
  /// the handles are posed.
  void update(const document::DocumentState& state, const live::PosedOrgans& organs,
              const std::vector<geometry::Plane>& planes, bool rest);

  /// The organs in the document's order.
  const std::vector<Organ>& organs() const { return organs_; }

private:
  struct Known {
    std::shared_ptr<const Points> points;
    std::uint64_t revision = 0;
    std::shared_ptr<const geometry::TriangleMesh> mesh;
  };

  void cut(const std::vector<std::size_t>& which, const std::vector<std::size_t>& planes, bool rest);

  Threads threads_;
  std::vector<geometry::Plane> planes_;
  std::vector<Organ> organs_;
  std::vector<Known> known_; ///< For each organ the points that were cut.
};

} // namespace viscera::presentation
