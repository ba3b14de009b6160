#pragma once

#include <QWidget>

#include "window/mode.h"

class QButtonGroup;

namespace viscera::app {

/// The slim column of modes at the left edge: an icon and a word each.
class ModeRail final : public QWidget {
  Q_OBJECT

public:
  explicit ModeRail(QWidget* parent = nullptr);

  void setMode(Mode mode);

Q_SIGNALS:
  void modeChosen(viscera::app::Mode mode);

private:
  QButtonGroup* buttons_;
};

} // namespace viscera::app
