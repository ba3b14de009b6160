#pragma once

#include <QWidget>

#include "viscera/anatomy/norms.h"

class QComboBox;
class QDoubleSpinBox;

namespace viscera::app {

class ViewModel;

/// The controls that choose for whom normal ranges are shown: women, men or either, and a body surface. The
/// choice is part of the view's state.
class PersonBox final : public QWidget {
  Q_OBJECT

public:
  explicit PersonBox(ViewModel& view, QWidget* parent = nullptr);

private:
  void choose();
  void sync();

  ViewModel& view_;
  QComboBox* sex_;
  QDoubleSpinBox* surface_;
};

} // namespace viscera::app
