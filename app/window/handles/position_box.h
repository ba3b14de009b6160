#pragma once

#include <QWidget>

#include <array>

#include "window/view/pose_editor.h"
#include "window/work/workspace.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace viscera::app {

/// Fields with the current handle's position, at rest or in the pose, in which a new one can be typed.
class PositionBox final : public QWidget {
  Q_OBJECT

public:
  enum class Of { rest, pose };

  /// `poses` keeps the locked volumes when a position in the pose is typed; may be null for positions at
  /// rest.
  PositionBox(Workspace& workspace, Of what, QWidget* parent = nullptr, PoseEditor* poses = nullptr);

private:
  void sync();
  void commit();
  Vec3 present(int row) const;

  Workspace& workspace_;
  Of what_;
  PoseEditor* poses_;
  QLabel* title_;
  QLabel* heading_ = nullptr; ///< Of the fields.
  std::array<QDoubleSpinBox*, 3> fields_{};
  QWidget* fieldBox_;
  std::vector<Subscription> subscriptions_;
};

/// Fields for a displacement, in mm along the patient's axes, by which the selected handles are moved.
class DisplacementBox final : public QWidget {
  Q_OBJECT

public:
  DisplacementBox(Workspace& workspace, PoseEditor& poses, QWidget* parent = nullptr);

private:
  void sync();
  void apply();

  Workspace& workspace_;
  PoseEditor& poses_;
  std::array<QDoubleSpinBox*, 3> fields_{};
  QPushButton* apply_;
  QLabel* result_;
  Subscription subscription_;
};

} // namespace viscera::app
