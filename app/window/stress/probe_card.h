#pragma once

#include <QFrame>

#include "window/stress/stress_model.h"

class QAction;
class QLabel;

namespace viscera::app {

/// A card over the view with the stress values at the clicked point, which follow the pose.
class ProbeCard final : public QFrame {
  Q_OBJECT

public:
  /// `pin` is the action that keeps the point.
  ProbeCard(StressModel& model, QAction* pin, QWidget* parent = nullptr);

  /// A place (mm, LPS) in the words of anatomy: "12.3 L, 4.0 P, 7.1 S".
  static QString placeInWords(const Vec3& place);

private:
  void sync();

  StressModel& model_;
  QLabel* place_;
  QLabel* position_;
  std::vector<QLabel*> names_;  ///< One for each quantity,
  std::vector<QLabel*> values_; ///< and its value.
};

} // namespace viscera::app
