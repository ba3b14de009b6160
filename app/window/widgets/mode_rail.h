#pragma once

#include <QWidget>

namespace viscera::app {

class ModeController;

/// The narrow column of buttons at the left edge that switch between modes, each an icon with a word.
class ModeRail final : public QWidget {
  Q_OBJECT

public:
  /// `modes` has all of them, and has to live longer.
  explicit ModeRail(ModeController& modes, QWidget* parent = nullptr);
};

} // namespace viscera::app
