#pragma once

#include <QWidget>

#include <array>

#include "window/workspace.h"

class QDoubleSpinBox;
class QLabel;

namespace viscera::app {

/// Where the current handle is, as numbers that can be typed: at rest, or in the pose.
class PositionBox final : public QWidget {
  Q_OBJECT

public:
  enum class Of { rest, pose };

  PositionBox(Workspace& workspace, Of what, QWidget* parent = nullptr);

private:
  void sync();
  void commit();
  Vec3 present(int row) const;

  Workspace& workspace_;
  Of what_;
  QLabel* title_;
  std::array<QDoubleSpinBox*, 3> fields_{};
  QWidget* fieldBox_;
  std::vector<session::Subscription> subscriptions_;
};

} // namespace viscera::app
