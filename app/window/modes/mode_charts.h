#pragma once

#include <QStackedWidget>

#include <vector>

#include "window/modes/mode_controller.h"

namespace viscera::app {

class StrainPanel;
class VolumePanel;
class WindowLayout;

/// Shows the strain of a heart where the user wants it, else the current mode's own chart if it has one and
/// that is switched on, else the chart of volumes.
class ModeCharts final : public QStackedWidget {
  Q_OBJECT

public:
  /// Takes `volumes` and `strain`; the others have to live longer.
  ModeCharts(ModeController& modes, VolumePanel* volumes, StrainPanel* strain, WindowLayout& layout);

private:
  void follow();

  ModeController& modes_;
  VolumePanel* volumes_;
  StrainPanel* strain_;
  WindowLayout& layout_;
  std::vector<QWidget*> ofModes_; ///< One for each mode.
};

} // namespace viscera::app
