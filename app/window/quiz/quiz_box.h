#pragma once

#include <QWidget>

#include "window/actions.h"
#include "window/quiz/quiz_tool.h"

class QLabel;

namespace viscera::app {

/// The names of parts, and the quiz that asks for them.
class QuizBox final : public QWidget {
  Q_OBJECT

public:
  QuizBox(QuizTool& tool, const Actions& actions, QWidget* parent = nullptr);

private:
  void sync();

  QuizTool& tool_;
  QLabel* question_;
  QLabel* result_;
};

} // namespace viscera::app
