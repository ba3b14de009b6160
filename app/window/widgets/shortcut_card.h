#pragma once

#include <QFrame>

#include "window/actions.h"

namespace viscera::app {

/// All shortcuts and what the mouse does, over the view.
class ShortcutCard final : public QFrame {
  Q_OBJECT

public:
  explicit ShortcutCard(const Actions& actions, QWidget* parent = nullptr);
};

} // namespace viscera::app
