#pragma once

#include <QWidget>

#include <array>

#include "window/pose_editor.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace viscera::app {

/// Moves the selected handles by a displacement that is typed, in mm along the patient's axes.
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
