#pragma once

#include <QWidget>

#include "window/pose_editor.h"

class QDoubleSpinBox;
class QPushButton;

namespace viscera::app {

/// Gives the current organ a volume that is typed, and back the one at rest.
class VolumeBox final : public QWidget {
  Q_OBJECT

public:
  VolumeBox(Workspace& workspace, PoseEditor& poses, QWidget* parent = nullptr);

  /// Shows the present volume, unless another one was typed.
  void sync();

private:
  Workspace& workspace_;
  PoseEditor& poses_;
  QDoubleSpinBox* field_;
  QPushButton* apply_;
  document::OrganId shown_; ///< The organ that the field is about.
  bool typed_ = false;      ///< Something was typed and not applied yet.
};

} // namespace viscera::app
