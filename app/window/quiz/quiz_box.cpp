#include "window/quiz/quiz_box.h"

#include <QAction>
#include <QCheckBox>
#include <QPushButton>

#include "window/widgets/ready_made.h"

namespace viscera::app {

QuizBox::QuizBox(const Actions& actions, QWidget* parent) : QWidget(parent) {
  auto* column = makeLayout<QVBoxLayout>(this, 6);
  auto* names = new QCheckBox(actions["view.parts"]->iconText(), this);
  names->setToolTip(actions["view.parts"]->toolTip());
  connect(names, &QCheckBox::toggled, actions["view.parts"], &QAction::setChecked);
  connect(actions["view.parts"], &QAction::toggled, names, &QCheckBox::setChecked);
  names->setChecked(actions["view.parts"]->isChecked());
  column->addWidget(names);
  column->addWidget(makeActionButton(actions["quiz.start"], this));
}

} // namespace viscera::app
