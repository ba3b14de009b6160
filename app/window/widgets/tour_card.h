#pragma once

#include <QFrame>

#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace viscera::app {

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

Q_SIGNALS:
  void ended();

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

} // namespace viscera::app
