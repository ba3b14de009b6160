#pragma once

#include <QWidget>

#include "window/work/actions.h"

namespace viscera::app {

/// The controls for the labels of organ parts, and the button that starts the quiz about them; its questions
/// stand on the view (`QuizPrompt`).
class QuizBox final : public QWidget {
  Q_OBJECT

public:
  explicit QuizBox(const Actions& actions, QWidget* parent = nullptr);
};

} // namespace viscera::app
