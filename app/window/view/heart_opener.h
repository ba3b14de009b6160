#pragma once

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

#include "viscera/live/heart_tissue.h"
#include "window/view/view_model.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// Has the tissue of the sample heart made by a worker as soon as the view cuts it open, so that a heart that
/// is never cut costs nothing. Until it is there, the cut shows the heart's surfaces.
class HeartOpener final : public QObject {
  Q_OBJECT

public:
  static constexpr const char* kSlot = "heart tissue"; ///< The slot of its job.

  /// Both have to live longer.
  HeartOpener(Workspace& workspace, ViewModel& model, QObject* parent = nullptr);

  /// The tissue that was made last; null before the first.
  const std::shared_ptr<const live::HeartTissue>& tissue() const { return tissue_; }

Q_SIGNALS:
  /// There is another tissue.
  void made();

private:
  void follow();
  void make(const live::SampleHeartOrgans& heart);

  Workspace& workspace_;
  ViewModel& model_;
  std::shared_ptr<const live::HeartTissue> tissue_;
  std::optional<live::SampleHeartOrgans>
      asked_; ///< The last heart; one that fails is not tried again in this cut.
  bool busy_ = false;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
