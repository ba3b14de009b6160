#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/inputs.h"
#include "viscera/document/document.h"
#include "viscera/document/scan_item.h"
#include "viscera/live/posed_organs.h"

namespace viscera::app::cli {

/// The organs and handles of a command in one fixed pose, for drawing them with `presentation::Presenter`.
class StillOrgans final : public live::PosedOrgans {
public:
  /// The organs at rest, in their order.
  explicit StillOrgans(std::vector<document::Organ> organs);

  /// Takes these handles, at rest, with the groups and the coordinates that they are for. All are shown, and
  /// none as locked.
  void setRig(document::Rig rig, document::SystemChoice system);
  document::OrganId idOf(std::size_t organ) const { return (*state_.organs)[organ]->id; }
  document::HandleId handle(int row) const {
    return state_.rig->handles.at(static_cast<std::size_t>(row)).id;
  }
  /// Takes a scan beside them.
  void setScan(std::shared_ptr<const document::ScanItem> scan) { state_.scan = std::move(scan); }
  /// Shows an organ at these points, `n x 3` mm.
  void setPoints(std::size_t organ, std::shared_ptr<const Points> points) {
    points_.at(organ) = std::move(points);
  }
  const document::DocumentState& state() const { return state_; }

  void showPose(const Points& pose) override { pose_ = pose; }
  const Points& shownPose() const override { return pose_; }
  std::shared_ptr<const Points> sharedPoints(document::OrganId organ) const override;
  std::uint64_t revision(document::OrganId) const override { return 1; }
  /// Volumes are not measured.
  live::OrganVolume volume(document::OrganId) override { return {}; }
  Values influence(document::OrganId, document::HandleId) const override { return {}; }
  const deformation::Deformer* bound(document::OrganId) const override { return nullptr; }

private:
  document::DocumentState state_;
  std::vector<std::shared_ptr<const Points>> points_;
  Points pose_ = Points(0, 3);
};

} // namespace viscera::app::cli
