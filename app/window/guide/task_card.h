#pragma once

#include <QFrame>

#include "window/work/workspace.h"

class QLabel;
class QTimer;

namespace viscera::app {

/// The first task of a new user: to drag a handle, which is chosen and bright. The card says so, and ends by
/// itself some seconds after it was done.
class TaskCard final : public QFrame {
  Q_OBJECT

public:
  TaskCard(Workspace& workspace, QWidget* parent);

  void start();
  /// Whether a handle was dragged since the start.
  bool done() const { return done_; }

private:
  void look(const document::Change& change);

  Workspace& workspace_;
  QLabel* text_;
  QTimer* end_;
  bool moved_ = false, done_ = false;
  Subscription subscription_;
};

} // namespace viscera::app
