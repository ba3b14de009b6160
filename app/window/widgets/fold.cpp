#include "window/widgets/fold.h"

#include <QToolButton>
#include <QVBoxLayout>

namespace viscera::app {

Fold::Fold(const QString& title, QWidget* contents, bool open, QWidget* parent)
    : QWidget(parent), title_(new QToolButton(this)), contents_(contents) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  title_->setObjectName(QStringLiteral("foldTitle"));
  title_->setText(title);
  title_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  title_->setCheckable(true);
  title_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  QFont font = title_->font();
  font.setBold(true);
  title_->setFont(font);
  column->addWidget(title_);
  column->addWidget(contents_);
  connect(title_, &QToolButton::toggled, this, &Fold::setOpen);
  setOpen(open);
}

void Fold::setOpen(bool open) {
  title_->setChecked(open);
  title_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
  contents_->setVisible(open);
}

bool Fold::isOpen() const {
  return title_->isChecked();
}

} // namespace viscera::app
