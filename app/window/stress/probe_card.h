#pragma once

#include <QFrame>

#include "window/stress/stress_model.h"

class QAction;
class QLabel;

namespace viscera::app {

/// The values at the point that was clicked, over the view; they follow the pose.
class ProbeCard final : public QFrame {
  Q_OBJECT

public:
  /// `pin` is the action that keeps the point.
  ProbeCard(StressModel& model, QAction* pin, QWidget* parent = nullptr);

private:
  void sync();

  StressModel& model_;
  QLabel* place_;
  QLabel* position_;
  std::vector<QLabel*> values_; ///< One for each quantity.
};

} // namespace viscera::app
