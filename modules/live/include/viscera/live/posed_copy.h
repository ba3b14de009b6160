#pragma once

#include <memory>

#include "viscera/live/posed_organs.h"

namespace viscera::live {

struct BoundOrgans;

/// The organs of a document as they were once (`LiveBinding::copy`), with poses of their own: they share the
/// surfaces and the bindings, so that the same pose gives the same points to the bit, and nothing that
/// happens to the document reaches them. For one thread, which need not be the document's.
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
