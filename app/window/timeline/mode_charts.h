#pragma once

#include <QStackedWidget>

#include <vector>

#include "window/modes/mode_controller.h"

namespace viscera::app {

class VolumePanel;
class WindowLayout;

/// Shows the current mode's own chart if it has one and that is switched on, else the chart of volumes.
class ModeCharts final : public QStackedWidget {
  Q_OBJECT

public:
  /// Takes `volumes`; the others have to live longer.
  ModeCharts(ModeController& modes, VolumePanel* volumes, WindowLayout& layout);

private:
  void follow();

  ModeController& modes_;
  VolumePanel* volumes_;
  WindowLayout& layout_;
  std::vector<QWidget*> ofModes_; ///< One for each mode.
};

} // namespace viscera::app
