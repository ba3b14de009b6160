#pragma once

#include <QFrame>

class QMenu;

namespace viscera::app {

/// What a first visitor can do, beside the beating heart: open a file, take a sample organ, or be shown
/// around.
class WelcomeCard final : public QFrame {
  Q_OBJECT

public:
  /// `samples` opens at "Sample organs"; it stays the caller's.
  explicit WelcomeCard(QMenu* samples, QWidget* parent = nullptr);

Q_SIGNALS:
  void openRequested();
  void tourRequested();
  void closed();
};

} // namespace viscera::app
