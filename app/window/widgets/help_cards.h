#pragma once

#include <QFrame>

#include <functional>
#include <vector>

class QLabel;
class QMenu;
class QMenuBar;
class QPushButton;

/// What help puts over the view.
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

/// One stop of the tour.
struct TourStep {
  QString title;
  QString text;
  std::function<void()> enter; ///< Brings the window to where the text is true.
};

/// Shows a visitor around, step by step, over the view; the window stays usable all the time.
class TourCard final : public QFrame {
  Q_OBJECT

public:
  explicit TourCard(std::vector<TourStep> steps, QWidget* parent = nullptr);

  void start();

private:
  void goTo(std::size_t step);

  std::vector<TourStep> steps_;
  std::size_t step_ = 0;
  QLabel* title_;
  QLabel* count_;
  QLabel* text_;
  QPushButton* back_;
  QPushButton* next_;
};

/// What the mouse does and all shortcuts, in the order of the menus, over the view.
class ShortcutCard final : public QFrame {
  Q_OBJECT

public:
  explicit ShortcutCard(const QMenuBar& menus, QWidget* parent = nullptr);
};

} // namespace viscera::app
