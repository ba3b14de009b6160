#pragma once

#include <QFrame>
#include <QStringList>

#include <functional>
#include <memory>
#include <vector>

class QLabel;
class QMenu;
class QMenuBar;
class QPushButton;

/// What help puts over the view.
namespace viscera::app {

class PointingFrame;

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
  QStringList targets;         ///< Names of the widgets that it speaks of: they get a frame.
  std::function<void()> enter; ///< Brings the window to where the text is true.
};

/// Shows a visitor around, step by step, over the view, and frames what each step speaks of; the window stays
/// usable all the time.
class TourCard final : public QFrame {
  Q_OBJECT

public:
  explicit TourCard(std::vector<TourStep> steps, QWidget* parent = nullptr);
  ~TourCard() override;

  void start();
  /// The names of the widgets that a step frames.
  const std::vector<TourStep>& steps() const { return steps_; }

protected:
  void hideEvent(QHideEvent* event) override;

private:
  void goTo(std::size_t step);

  std::vector<TourStep> steps_;
  std::size_t step_ = 0;
  std::vector<std::unique_ptr<PointingFrame>> frames_;
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
