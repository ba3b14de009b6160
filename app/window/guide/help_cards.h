#pragma once

#include <QFrame>
#include <QPointer>
#include <QStringList>

#include <functional>
#include <vector>

class QLabel;
class QMenu;
class QMenuBar;
class QPushButton;

/// The cards that the help shows over the view: welcome, tour and shortcuts.
namespace viscera::app {

class PointingFrame;

/// The card of the first start, which offers to open a file, to load a sample organ, or to begin the tour. In
/// a small view it leaves out what is also in the menus, so that an organ can be seen below it.
class WelcomeCard final : public QFrame {
  Q_OBJECT

public:
  /// `samples` opens at "Sample organs"; the caller keeps ownership. The card is shown over `parent`.
  WelcomeCard(QMenu* samples, QWidget* parent);

Q_SIGNALS:
  void openRequested();
  void taskRequested();
  void tourRequested();
  void closed();
  /// The card is there and so high, or is gone (0).
  void heightTaken(int pixels);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  void fit();
  int heightIn(int width) const;

  std::vector<QWidget*> lesser_; ///< The widgets that are hidden when there is little room, the first one
                                 ///< first.
};

/// One stop of the tour.
struct TourStep {
  QString title;
  QString text;
  QStringList targets;         ///< Names of the widgets that the step explains; they get a frame.
  std::function<void()> enter; ///< Puts the window into the state that the text describes.
};

/// A card that leads a new user through the window step by step and frames what each step explains; the
/// window stays usable.
class TourCard final : public QFrame {
  Q_OBJECT

public:
  explicit TourCard(std::vector<TourStep> steps, QWidget* parent = nullptr);
  ~TourCard() override;

  void start();
  /// The names of the widgets that a step frames.
  const std::vector<TourStep>& steps() const { return steps_; }

protected:
  /// While the tour is shown, Return and Space go on, wherever the focus is but in a field.
  bool eventFilter(QObject* watched, QEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  void goTo(std::size_t step);
  void dropFrames();

  std::vector<TourStep> steps_;
  std::size_t step_ = 0;
  std::vector<QPointer<PointingFrame>> frames_; ///< The window's.
  QLabel* title_;
  QLabel* count_;
  QLabel* text_;
  QPushButton* back_;
  QPushButton* next_;
};

/// A card that lists what the mouse does and all shortcuts, in the order of the menus.
class ShortcutCard final : public QFrame {
  Q_OBJECT

public:
  explicit ShortcutCard(const QMenuBar& menus, QWidget* parent = nullptr);
};

} // namespace viscera::app
