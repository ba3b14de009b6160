#include "window/view/view_area.h"

#include <QGridLayout>
#include <QLabel>
#include <QTimer>

namespace viscera::app {
namespace {
constexpr int kMargin = 12;
constexpr int kBadgeMilliseconds = 4000;
} // namespace

ViewArea::ViewArea(QWidget* parent)
    : QWidget(parent), grid_(new QGridLayout(this)), view_(new ViewWidget(this)),
      messages_(new MessageBar(this)), badge_(new QLabel(this)), badgeTimer_(new QTimer(this)) {
  setObjectName(QStringLiteral("central"));
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(0);
  // The view fills all nine cells; the inner ones hold what lies over it, away from the edges.
  for (const int edge : {0, 2}) {
    grid_->setRowMinimumHeight(edge, kMargin);
    grid_->setColumnMinimumWidth(edge, kMargin);
  }
  grid_->setRowStretch(1, 1);
  grid_->setColumnStretch(1, 1);
  grid_->addWidget(view_, 0, 0, 3, 3);
  grid_->addWidget(messages_, 1, 1, Qt::AlignTop);
  grid_->addWidget(badge_, 1, 1, Qt::AlignTop | Qt::AlignLeft);
  badge_->setObjectName(QStringLiteral("viewBadge"));
  badge_->setAttribute(Qt::WA_TransparentForMouseEvents);
  badge_->hide();
  badgeTimer_->setSingleShot(true);
  connect(badgeTimer_, &QTimer::timeout, badge_, &QWidget::hide);
}

void ViewArea::showBadge(const QString& text) {
  badge_->setText(text);
  badge_->setVisible(messages_->isHidden());
  badge_->raise();
  badgeTimer_->start(kBadgeMilliseconds);
}

void ViewArea::addCard(QWidget* card, Qt::Alignment alignment) {
  grid_->addWidget(card, 1, 1, alignment);
  card->raise();
}

} // namespace viscera::app
