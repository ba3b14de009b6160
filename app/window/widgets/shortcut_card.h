#pragma once

#include <QFrame>

class QMenuBar;

namespace viscera::app {

/// What the mouse does and all shortcuts, in the order of the menus, over the view.
class ShortcutCard final : public QFrame {
  Q_OBJECT

public:
  explicit ShortcutCard(const QMenuBar& menus, QWidget* parent = nullptr);
};

} // namespace viscera::app
