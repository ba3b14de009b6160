#include "window/quiz/quiz_prompt.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {
constexpr int kPromptWidth = 460;
constexpr int kPromptTop = 12;
constexpr double kPromptType = 1.4; ///< Of the window's type: it is read from the last row.
} // namespace

QuizPrompt::QuizPrompt(QuizTool& tool, QWidget& view)
    : QFrame(&view), tool_(tool), question_(new QLabel(this)), result_(new QLabel(this)),
      score_(new QLabel(this)) {
  setObjectName(QStringLiteral("quizPrompt"));
  auto* column = makeLayout<QVBoxLayout>(this, 4, {16, 10, 16, 10});
  for (QLabel* label : {question_, result_, score_}) {
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignHCenter);
    column->addWidget(label);
  }
  question_->setObjectName(QStringLiteral("quizQuestion"));
  result_->setObjectName(QStringLiteral("quizResult"));
  score_->setObjectName(QStringLiteral("quizScore"));
  embolden(question_, kPromptType);
  choices_ = new QHBoxLayout;
  column->insertLayout(1, choices_);
  view.installEventFilter(this);
  connect(&tool, &QuizTool::changed, this, &QuizPrompt::sync);
  sync();
}

bool QuizPrompt::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize)
    place();
  return QFrame::eventFilter(watched, event);
}

void QuizPrompt::sync() {
  while (QLayoutItem* item = choices_->takeAt(0)) {
    item->widget()->deleteLater(); // One of them may be what was pressed.
    item->widget()->hide();
    delete item;
  }
  const QStringList choices = tool_.choices();
  for (int i = 0; i < choices.size(); ++i) {
    auto* button = new QPushButton(choices.at(i), this);
    button->setObjectName(QStringLiteral("quizChoice"));
    connect(button, &QPushButton::clicked, this, [this, i] { tool_.choose(i); });
    choices_->addWidget(button);
  }
  question_->setText(tool_.question());
  result_->setText(tool_.result());
  result_->setVisible(!tool_.result().isEmpty());
  score_->setText(tool_.score());
  score_->setVisible(!tool_.score().isEmpty());
  setVisible(tool_.active());
  place();
}

void QuizPrompt::place() {
  if (isHidden())
    return;
  const int wide = std::min(kPromptWidth, parentWidget()->width() - 2 * kPromptTop);
  setFixedWidth(std::max(1, wide));
  layout()->activate();
  resize(width(),
         layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width()) : sizeHint().height());
  move((parentWidget()->width() - width()) / 2, kPromptTop);
  raise();
}

} // namespace viscera::app
