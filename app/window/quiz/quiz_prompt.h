#pragma once

#include <QFrame>

#include "window/quiz/quiz_tool.h"

class QHBoxLayout;
class QLabel;

namespace viscera::app {

/// The question of the quiz on the view, with the score, and with buttons where it has choices. Shown while
/// the quiz is on.
class QuizPrompt final : public QFrame {
  Q_OBJECT

public:
  /// Lies over `view`, at its upper edge. `tool` has to live longer, or as long as the view.
  QuizPrompt(QuizTool& tool, QWidget& view);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void sync();
  void place();

  QuizTool& tool_;
  QLabel* question_;
  QLabel* result_;
  QLabel* score_;
  QHBoxLayout* choices_;
};

} // namespace viscera::app
