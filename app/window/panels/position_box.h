#pragma once

#include <QWidget>

#include <array>

#include "window/pose_editor.h"
#include "window/workspace.h"

class QDoubleSpinBox;
class QLabel;

namespace viscera::app {

/// Where the current handle is, as numbers that can be typed: at rest, or in the pose.
class PositionBox final : public QWidget {
  Q_OBJECT

public:
  enum class Of { rest, pose };

  /// `poses` keeps the locked volumes when a place in the pose is typed; not needed for places at rest.
  PositionBox(Workspace& workspace, Of what, QWidget* parent = nullptr, PoseEditor* poses = nullptr);

private:
  void sync();
  void commit();
  Vec3 present(int row) const;

  Workspace& workspace_;
  Of what_;
  PoseEditor* poses_;
  QLabel* title_;
  std::array<QDoubleSpinBox*, 3> fields_{};
  QWidget* fieldBox_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
