#pragma once

#include <QWidget>

#include "window/actions.h"
#include "window/quiz/quiz_tool.h"

class QLabel;

namespace viscera::app {

/// The controls for the labels of organ parts, and for the quiz about them.
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
