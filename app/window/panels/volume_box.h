#pragma once

#include <QWidget>

#include "window/pose_editor.h"

class QDoubleSpinBox;
class QPushButton;

namespace viscera::app {

/// The controls that give the current organ a typed volume, or its volume at rest.
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
  document::OrganId shown_; ///< The organ whose volume the field shows.
  bool typed_ = false;      ///< A number was typed and is not applied yet.
};

} // namespace viscera::app
