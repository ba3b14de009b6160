#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "viscera/document/document.h"
#include "viscera/document/organ.h"
#include "viscera/geometry/plane_cut.h"
#include "viscera/live/posed_organs.h"

namespace viscera::presentation {

/// Where planes cut a document's organs, as they are posed and at rest. Cuts again only what has moved.
class SliceCuts {
public:
  /// An organ that is seen, and its cut by every plane.
  struct Organ {
    std::shared_ptr<const document::Organ> organ;
    std::vector<geometry::PlaneCut> posed;
    std::vector<geometry::PlaneCut> rest; ///< Empty where the organ is at rest, or that was not asked for.
  };

  explicit SliceCuts(Threads threads) : threads_(threads) {}

  /// Brings the cuts of all visible organs by `planes` up to date; with `rest` those at rest too while the
  /// handles are not.
  void update(const document::DocumentState& state, const live::PosedOrgans& organs,
              const std::vector<geometry::Plane>& planes, bool rest);

  /// In the document's order.
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
  std::vector<Known> known_; ///< Of each organ what was cut.
};

} // namespace viscera::presentation
