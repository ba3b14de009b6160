#include "window/quiz/quiz_box.h"

#include <QAction>
#include <QCheckBox>
#include <QPushButton>

#include "window/widgets/ready_made.h"
#include "window/widgets/wrapped_label.h"

namespace viscera::app {

QuizBox::QuizBox(QuizTool& tool, const Actions& actions, QWidget* parent)
    : QWidget(parent), tool_(tool), question_(new WrappedLabel(this)), result_(makeRemark(QString(), this)) {
  auto* column = makeLayout<QVBoxLayout>(this, 6);
  auto* names = new QCheckBox(actions["view.parts"]->iconText(), this);
  names->setToolTip(actions["view.parts"]->toolTip());
  connect(names, &QCheckBox::toggled, actions["view.parts"], &QAction::setChecked);
  connect(actions["view.parts"], &QAction::toggled, names, &QCheckBox::setChecked);
  names->setChecked(actions["view.parts"]->isChecked());
  column->addWidget(names);
  column->addWidget(makeActionButton(actions["quiz.start"], this));
  question_->setObjectName(QStringLiteral("quizQuestion"));
  embolden(question_);
  column->addWidget(question_);
  result_->setObjectName(QStringLiteral("quizResult"));
  column->addWidget(result_);
  connect(&tool, &QuizTool::changed, this, &QuizBox::sync);
  sync();
}

void QuizBox::sync() {
  question_->setText(tool_.question());
  result_->setText(tool_.result());
  question_->setVisible(tool_.active());
  result_->setVisible(!tool_.result().isEmpty());
}

} // namespace viscera::app
