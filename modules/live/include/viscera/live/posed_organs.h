#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/deformation/deformer.h"
#include "viscera/document/ids.h"

namespace viscera::live {

/// The present volume of an organ and its volume at rest. Meaningless for an open surface.
struct OrganVolume {
  bool closed = false;
  double restMl = 0;
  double nowMl = 0;

  double changeMl() const { return nowMl - restMl; }
  double relativeChange() const { return restMl != 0 ? (nowMl - restMl) / restMl : 0; }
};

/// The interface to the organs of a document in a pose of its handles: the open document's (`LiveBinding`),
/// or a copy of them that a movie moves on a thread of its own (`PosedCopy`). Code that draws, measures or
/// plays organs uses this interface. All members throw `UsageError` for an unknown organ.
class PosedOrgans {
public:
  virtual ~PosedOrgans() = default;

  /// Poses all organs: `n x 3` mm, in the order of the rig. Throws `DataError` for a pose of another size or
  /// one that is not finite.
  virtual void showPose(const Points& pose) = 0;
  /// The displayed positions of the handles, `n x 3` mm, in the order of the rig. The reference is valid
  /// until another pose is shown.
  virtual const Points& shownPose() const = 0;

  /// The organ's vertices, `n x 3` mm: they follow the pose in place as long as the organ stays bound, and
  /// the pointer shares ownership of the memory.
  virtual std::shared_ptr<const Points> sharedPoints(document::OrganId organ) const = 0;
  /// A number that changes whenever the organ's vertices have other values or another place in memory.
  virtual std::uint64_t revision(document::OrganId organ) const = 0;
  /// Volume at rest and now. The first request after a move measures all organs that have moved, in one
  /// parallel loop, O(triangles); every other request in the same pose costs nothing. So each reader of a
  /// volume asks here.
  virtual OrganVolume volume(document::OrganId organ) = 0;
  /// The influence of a handle on every vertex, or empty when the organ is not bound to it.
  virtual Values influence(document::OrganId organ, document::HandleId handle) const = 0;
  /// The organ bound to the present handles, for keeping volumes; null when it follows no handles. Throws
  /// `DataError` while that is not known, because it is being bound or binding was cancelled.
  virtual const deformation::Deformer* bound(document::OrganId organ) const = 0;
};

struct BoundOrgans;

/// A copy of the organs of a document (`LiveBinding::copy`) that has a pose of its own: the copy shares the
/// surfaces and the bindings, so that the same pose gives the same points to the bit, and changes of the
/// document do not affect the copy. For one thread, which need not be the document's.
class PosedCopy final : public PosedOrgans {
public:
  explicit PosedCopy(std::unique_ptr<BoundOrgans> organs);
  PosedCopy(PosedCopy&&) noexcept;
  ~PosedCopy() override;

  void showPose(const Points& pose) override;
  const Points& shownPose() const override;
  std::shared_ptr<const Points> sharedPoints(document::OrganId organ) const override;
  std::uint64_t revision(document::OrganId organ) const override;
  OrganVolume volume(document::OrganId organ) override;
  Values influence(document::OrganId organ, document::HandleId handle) const override;
  const deformation::Deformer* bound(document::OrganId organ) const override;

private:
  std::unique_ptr<BoundOrgans> organs_;
};

} // namespace viscera::live
