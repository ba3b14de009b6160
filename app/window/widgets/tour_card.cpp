#include "window/widgets/tour_card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "window/style/icon.h"

namespace viscera::app {

TourCard::TourCard(std::vector<TourStep> steps, QWidget* parent)
    : QFrame(parent), steps_(std::move(steps)), title_(new QLabel(this)), count_(new QLabel(this)),
      text_(new QLabel(this)), back_(new QPushButton(tr("Back"), this)), next_(new QPushButton(this)) {
  setObjectName(QStringLiteral("welcomeCard"));
  setFixedWidth(400);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 10, 12, 14);
  column->setSpacing(8);
  auto* heading = new QHBoxLayout;
  QFont font = title_->font();
  font.setBold(true);
  font.setPointSizeF(font.pointSizeF() * 1.25);
  title_->setFont(font);
  count_->setObjectName(QStringLiteral("muted"));
  auto* closeButton = new QToolButton(this);
  closeButton->setIcon(icon("close"));
  closeButton->setIconSize(QSize(14, 14));
  closeButton->setToolTip(tr("End the tour"));
  closeButton->setAccessibleName(tr("End the tour"));
  heading->addWidget(title_, 1);
  heading->addWidget(count_);
  heading->addWidget(closeButton);
  column->addLayout(heading);
  text_->setWordWrap(true);
  column->addWidget(text_);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch(1);
  buttons->addWidget(back_);
  buttons->addWidget(next_);
  next_->setObjectName(QStringLiteral("primary"));
  column->addLayout(buttons);
  const auto end = [this] {
    hide();
    Q_EMIT ended();
  };
  connect(closeButton, &QToolButton::clicked, this, end);
  connect(back_, &QPushButton::clicked, this, [this] { goTo(step_ - 1); });
  connect(next_, &QPushButton::clicked, this, [this, end] {
    if (step_ + 1 < steps_.size())
      goTo(step_ + 1);
    else
      end();
  });
  hide();
}

void TourCard::start() {
  goTo(0);
  show();
  raise();
  next_->setFocus();
}

void TourCard::goTo(std::size_t step) {
  step_ = step;
  const TourStep& present = steps_[step];
  title_->setText(present.title);
  text_->setText(present.text);
  count_->setText(tr("%1 of %2").arg(step + 1).arg(steps_.size()));
  back_->setEnabled(step > 0);
  next_->setText(step + 1 < steps_.size() ? tr("Next") : tr("Done"));
  if (present.enter)
    present.enter();
  adjustSize();
}

} // namespace viscera::app
