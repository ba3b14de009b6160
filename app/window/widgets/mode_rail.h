#pragma once

#include <QWidget>

namespace viscera::app {

class ModeController;

/// The slim column of modes at the left edge: an icon and a word each.
class ModeRail final : public QWidget {
  Q_OBJECT

public:
  /// `modes` has all of them, and has to live longer.
  explicit ModeRail(ModeController& modes, QWidget* parent = nullptr);
};

} // namespace viscera::app
