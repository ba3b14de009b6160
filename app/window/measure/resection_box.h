#pragma once

#include <QTimer>
#include <QTreeWidget>
#include <QWidget>

#include "window/view/view_model.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// What the plane that cuts the organs open would leave of each, and take away: a table that follows the
/// plane and the pose, ten times a second at most. Without a cut, or where it meets no closed organ, it takes
/// no room.
class ResectionBox final : public QWidget {
  Q_OBJECT

public:
  /// All have to live longer.
  ResectionBox(Workspace& workspace, const ViewModel& view, QWidget* parent = nullptr);

protected:
  void showEvent(QShowEvent* event) override;

private:
  void outdated();
  void sync();

  Workspace& workspace_;
  const ViewModel& view_;
  QTreeWidget* list_;
  QTimer soon_;
  presentation::OrganCut cut_; ///< Of the last change.
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
